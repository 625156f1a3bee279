#include "suites/suite.hpp"

namespace ecods::bench {

std::vector<Suite> all_suites() {
    return {{"narrow", run_narrow},        {"broad", run_broad},           {"system", run_system},
            {"rooms", run_rooms},          {"hover", run_hover},           {"assembly", run_assembly},
            {"memory", run_memory},        {"predicates", run_predicates}, {"stability", run_stability},
            {"hard_cases", run_hard_cases}};
}

}  // namespace ecods::bench
