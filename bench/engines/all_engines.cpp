#include "engines/broad_phase_kinds.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

std::vector<EngineMaker> all_engines() {
    std::vector<EngineMaker> makers;
    for (const NamedBroadPhase& named : broad_phase_kinds) {
        makers.push_back({std::string("ECoDS, ") + named.name, true,
                          [kind = named.kind](const scenes::Scene& scene) { return set_up_world(scene, kind); }});
    }
    makers.push_back({"ECoDS, all pairs", true, set_up_ecods_all_pairs});
    makers.push_back({scene_yardstick, false, set_up_fcl_tree});
    makers.push_back({"FCL, all pairs", false, set_up_fcl_all_pairs});
    return makers;
}

}  // namespace ecods::bench
