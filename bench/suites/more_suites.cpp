#include "suites/suite.hpp"

#include "engines/broad_engine.hpp"
#include "engines/cast_engine.hpp"
#include "engines/convex_engine.hpp"
#include "engines/distance_engine.hpp"
#include "engines/hit_engine.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/polytopes_engine.hpp"
#include "engines/rounded_engine.hpp"
#include "engines/scene_engine.hpp"
#include "engines/turn_engine.hpp"

namespace ecods::bench {

std::vector<Suite> all_suites() {
    return {{"narrow", run_narrow, names_of(narrow_engines())},
            {"distance", run_distance, names_of(distance_engines())},
            {"casts", run_casts, names_of(hit_engines(), cast_engines())},
            {"turn", run_turns, names_of(turn_engines())},
            {"solids", run_solids},
            {"certificates", run_certificates},
            {"convex", run_convex,
             names_of(convex_engines(scenes::ConvexQuestion::distance), convex_engines(scenes::ConvexQuestion::depth),
                      polytopes_engines())},
            {"rounded", run_rounded, names_of(round_engines())},
            {"arm", run_arm},
            {"broad", run_broad, names_of(broad_engines())},
            {"system", run_system, names_of(system_engines())},
            {"rooms", run_rooms},
            {"hover", run_hover},
            {"assembly", run_assembly},
            {"memory", run_memory, names_of(narrow_engines(), broad_engines(), scene_engines()), false},
            {"predicates", run_predicates},
            {"stability", run_stability},
            {"hard_cases", run_hard_cases, names_of(narrow_engines())}};
}

}  // namespace ecods::bench
