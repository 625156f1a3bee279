// A build for the main job alone has no other suites.
#include "suites/suite.hpp"

namespace ecods::bench {

std::vector<Suite> all_suites() {
    return main_suites();
}

}  // namespace ecods::bench
