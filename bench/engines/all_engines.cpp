// The engines of the main job, in the order in which tables show them.
#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/scene_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> main_narrow_engines() {
    return joined(ecods_narrow(), fcl_narrow(), ode_narrow());
}

std::vector<BroadMaker> main_broad_engines() {
    return joined(ecods_broad(), scratch_broad(), fcl_broad(), bullet_broad());
}

std::vector<SceneMaker> scene_engines() {
    return joined(ecods_worlds(), ecods_all_pairs(), fcl_scenes());
}

std::vector<SceneMaker> system_engines() {
    return joined(ecods_worlds(), fcl_scenes());
}

}  // namespace ecods::bench
