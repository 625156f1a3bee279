#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

BroadMaker ecods_maker(BroadPhaseKind kind, const std::string& name) {
    return {"ECoDS, " + name, "BroadPhase: move(), update(), pairs()", true, std::numeric_limits<std::size_t>::max(),
            [kind](const scenes::MovingBoxes& boxes) { return set_up_broad_ecods(kind, boxes); }};
}

}  // namespace

std::vector<BroadMaker> broad_engines() {
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    std::vector<BroadMaker> makers = {
        ecods_maker(BroadPhaseKind::sweep_and_prune, "sweep and prune"),
        ecods_maker(BroadPhaseKind::brute_force, "brute force"),
        {broad_yardstick, "update() of the moved objects, collide() with a callback that notes each pair; double",
         false, any, set_up_broad_fcl_tree},
        {"FCL DynamicAABBTree_Array", "the same", false, any, set_up_broad_fcl_array},
        {"Bullet Dbvt",
         "btDbvtBroadphase: setAabb(), calculateOverlappingPairs(), then its pairs, whose boxes are tested as its "
         "dispatcher does; float",
         false, any, set_up_broad_bullet_dbvt},
        {"Bullet AxisSweep3", "btAxisSweep3, the same; 16 bits, then float", false, 16000, set_up_broad_bullet_sweep},
        {"ODE SAP space", "dSweepAndPruneSpace: dGeomSetPosition(), dSpaceCollide(); double", false, 10000,
         set_up_broad_ode},
        {"Embree rtcCollide",
         "user geometry, dynamic scene of low build quality, rebuilt each frame, one thread; float", false, any,
         set_up_broad_embree},
        {"CGAL box_self_intersection_d", "closed boxes, from scratch each frame; double", false, 10000,
         set_up_broad_cgal}};
    // Every box against every other: for small scenes.
    makers[1].count_max = 10000;
    return makers;
}

}  // namespace ecods::bench
