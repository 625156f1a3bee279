// What a clearance costs: a part of the suite of distances.
#pragma once

#include "suites/suite.hpp"

namespace ecods::bench {

// `is_right` becomes false if the collisions are others than without a clearance.
Table clearance_table(const SuiteOptions& options, bool& is_right);

}  // namespace ecods::bench
