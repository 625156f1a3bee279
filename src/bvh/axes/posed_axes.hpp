// Posed trees are projected to three axes, in doubles and in floats, with the bounds that separating_axes.hpp derives.
// One set of axes is computed in registers of four doubles, or two sets side by side in registers of eight, by the same
// operations in the same order.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "base/arithmetic.hpp"
#include "bounds/double4.hpp"
#include "bvh/axes/separating_axes.hpp"
#include "simd/dispatch.hpp"

namespace ecods::axes {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double float_u = 0x1p-23;
inline constexpr double underflow = 0x1p-100;
inline constexpr double sum_max = 0x1p100;
inline constexpr double factor_max = 0x1p900;
inline constexpr double world_max = 0x1p1000;
inline constexpr double unit_distance_max = 0x1p-40;  // with larger distances, margins would grow too much

// Names the tree whose face normals the axes are.
enum class Own { a, b };

}  // namespace ecods::axes

#define ECODS_TEXT "bvh/axes/posed_axes_text.hpp"
#include "simd/each_set.hpp"
