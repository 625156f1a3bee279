// Convex polytopes that move in a box: all distances below their size, frame by frame.
#pragma once

#include <optional>

#include "report/table.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

// Nothing if none of its engines is asked for. `is_right` becomes false where an answer of ECoDS is not the oracle's,
// or its engines answer differently.
std::optional<Table> convex_frames_table(const SuiteOptions& options, bool& is_right);

}  // namespace ecods::bench
