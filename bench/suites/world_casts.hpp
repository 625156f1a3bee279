// Casts and moves in a world, beside the same put together from questions about two bodies.
#pragma once

#include "suites/suite.hpp"

namespace ecods::bench {

SuiteResult run_world_casts(const SuiteOptions& options);

}  // namespace ecods::bench
