// A build for the main job alone has no other engines.
#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> more_narrow_engines() {
    return {};
}

std::vector<BroadMaker> more_broad_engines() {
    return {};
}

}  // namespace ecods::bench
