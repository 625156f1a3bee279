// ProjectedLanes projects the eight boxes or triangles of a node to the axes of a set (separating_axes.hpp). This is
// the first step of all kernels that compare two nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bvh/axes/separating_axes.hpp"
#include "simd/vec.hpp"

#define ECODS_TEXT "bvh/masks/projected_lanes_text.hpp"
#include "simd/each_set.hpp"
