#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/scene_engine.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

std::vector<Suite> main_suites() {
    return {{"narrow", run_narrow, names_of(main_narrow_engines())},
            {"broad", run_broad, names_of(main_broad_engines())},
            {"system", run_system, names_of(system_engines())},
            {"rooms", run_rooms}};
}

}  // namespace ecods::bench
