// The work of the sweep and prune as it grows with the number of boxes.
#pragma once

#include <cstddef>

#include "report/table.hpp"

namespace ecods::bench {

// Swaps and box tests per box and frame in the dense scene, from 250 boxes, doubled up to `count_max`, and the power of
// the number of boxes that they grow with.
Table swap_table(std::size_t count_max, std::size_t frame_count);

}  // namespace ecods::bench
