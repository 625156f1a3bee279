#include "engines/engine.hpp"

namespace ecods::bench {

std::vector<EngineMaker> all_engines() {
    return {{"ECoDS, sweep and prune", true, set_up_sweep_and_prune},
            {"ECoDS, brute force", true, set_up_brute_force},
            {"ECoDS, all pairs", true, set_up_ecods_all_pairs},
            {"FCL, DynamicAABBTree", false, set_up_fcl_tree},
            {"FCL, all pairs", false, set_up_fcl_all_pairs}};
}

}  // namespace ecods::bench
