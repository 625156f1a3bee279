// What is in the way, and when: segments against a mesh, casts of two meshes, and both in a world.
#include <iterator>
#include <utility>

#include "suites/parts.hpp"

namespace ecods::bench {

SuiteResult run_casts(const SuiteOptions& options) {
    SuiteResult result;
    for (SuiteResult (*const part)(const SuiteOptions&) : {run_hits, run_two_body_casts, run_world_casts}) {
        SuiteResult of_part = part(options);
        result.is_right &= of_part.is_right;
        std::move(of_part.sections.begin(), of_part.sections.end(), std::back_inserter(result.sections));
    }
    return result;
}

}  // namespace ecods::bench
