// A build for the main job alone has no other engines.
#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> narrow_engines() {
    return main_narrow_engines();
}

std::vector<BroadMaker> broad_engines() {
    return main_broad_engines();
}

}  // namespace ecods::bench
