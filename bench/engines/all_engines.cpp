#include "engines/broad_phase_kinds.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

namespace {

constexpr const char* ecods_all_pairs = "ECoDS, all pairs";

}  // namespace

std::vector<EngineMaker> all_engines() {
    std::vector<EngineMaker> makers;
    for (const NamedBroadPhase& named : broad_phase_kinds) {
        makers.push_back({std::string("ECoDS, ") + named.name, true,
                          [kind = named.kind](const scenes::Scene& scene) { return set_up_world(scene, kind); }});
    }
    makers.push_back({ecods_all_pairs, true, set_up_ecods_all_pairs});
    makers.push_back({scene_yardstick, false, set_up_fcl_tree});
    makers.push_back({"FCL, all pairs", false, set_up_fcl_all_pairs});
    return makers;
}

std::vector<EngineMaker> system_engines() {
    std::vector<EngineMaker> makers = all_engines();
    std::erase_if(makers, [](const EngineMaker& maker) { return maker.name == ecods_all_pairs; });
    return makers;
}

}  // namespace ecods::bench
