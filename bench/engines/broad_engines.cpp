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

std::vector<BroadMaker> main_broad_engines() {
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
        {"Bullet Dbvt",
         "btDbvtBroadphase: setAabb(), calculateOverlappingPairs(), then its pairs, whose boxes are tested as its "
         "dispatcher does; float",
         false, any, set_up_broad_bullet_dbvt}};
    makers.insert(makers.end(), std::begin(others), std::end(others));
    return makers;
}

std::vector<BroadMaker> broad_engines() {
    std::vector<BroadMaker> makers = main_broad_engines();
    for (BroadMaker& more : more_broad_engines()) makers.push_back(std::move(more));
    return makers;
}

}  // namespace ecods::bench
