// Casts of two meshes: times and errors of every engine of casts.
#pragma once

#include "suites/suite.hpp"

namespace ecods::bench {

SuiteResult run_two_body_casts(const SuiteOptions& options);

}  // namespace ecods::bench
