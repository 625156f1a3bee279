// Segments against one mesh: times and errors of every engine of hits.
#pragma once

#include "suites/suite.hpp"

namespace ecods::bench {

SuiteResult run_hits(const SuiteOptions& options);

}  // namespace ecods::bench
