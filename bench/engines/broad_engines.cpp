#include <iterator>

#include "engines/broad_engine.hpp"
#include "engines/broad_phase_kinds.hpp"

namespace ecods::bench {

namespace {

BroadMaker ecods_maker(const NamedBroadPhase& named) {
    // Every box against every other: for small scenes.
    const std::size_t count_max =
        named.kind == BroadPhaseKind::brute_force ? 1000 : std::numeric_limits<std::size_t>::max();
    return {std::string("ECoDS, ") + named.name, "BroadPhase: move(), update(), pairs()", true, count_max,
            [kind = named.kind](const scenes::MovingBoxes& boxes) { return set_up_broad_ecods(kind, boxes); }};
}

}  // namespace

std::vector<BroadMaker> broad_engines() {
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    std::vector<BroadMaker> makers;
    for (const NamedBroadPhase& named : broad_phase_kinds) makers.push_back(ecods_maker(named));
    const BroadMaker others[] = {
        {broad_scratch,
         "internal: everything sorted and swept in each frame; pairs ascending, and those that came and went", true,
         any, set_up_broad_scratch},
        {broad_scratch_unsorted, "internal: the same; pairs in the order in which they are found, and nothing else",
         true, any, set_up_broad_scratch_unsorted},
        {broad_yardstick, "update() of all, collide() with a callback that notes each pair; double", false, any,
         set_up_broad_fcl_tree},
        {"FCL tree, moved only", "update() of the moved objects, the rest the same", false, 10000,
         set_up_broad_fcl_tree_moved},
        {"FCL DynamicAABBTree_Array", "as the first", false, 1000, set_up_broad_fcl_array},
        {broad_fcl_sweep,
         "SaPCollisionManager, as the first. NOT TO BE RELIED ON: it loses pairs and reports false ones", false, 10000,
         set_up_broad_fcl_sweep, std::chrono::seconds(30)},
        {"Bullet Dbvt",
         "btDbvtBroadphase: setAabb(), calculateOverlappingPairs(), then its pairs, whose boxes are tested as its "
         "dispatcher does; float",
         false, any, set_up_broad_bullet_dbvt},
        {"Bullet AxisSweep3", "btAxisSweep3, the same; 16 bits, then float", false, 1000, set_up_broad_bullet_sweep},
        {"ODE SAP space", "dSweepAndPruneSpace: dGeomSetPosition(), dSpaceCollide(); double", false, 10000,
         set_up_broad_ode},
        {"Embree rtcCollide",
         "user geometry, dynamic scene of low build quality, rebuilt each frame, one thread; float", false, any,
         set_up_broad_embree},
        {"CGAL box_self_intersection_d", "closed boxes, from scratch each frame; double", false, 1000,
         set_up_broad_cgal}};
    makers.insert(makers.end(), std::begin(others), std::end(others));
    return makers;
}

}  // namespace ecods::bench
