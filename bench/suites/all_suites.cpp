#include "suites/suite.hpp"

namespace ecods::bench {

std::vector<Suite> all_suites() {
    return {{"rooms", run_rooms},           {"system", run_system},      {"hover", run_hover},
            {"assembly", run_assembly},     {"narrow", run_narrow},      {"broad", run_broad},
            {"predicates", run_predicates}, {"stability", run_stability}};
}

}  // namespace ecods::bench
