// Registers of four doubles hold vectors and matrices of three dimensions; the code is compiled once for each
// instruction set (simd/region.hpp). Products of matrices and vectors add from left to right, so all sets give the same
// bits.
#pragma once

#include <algorithm>

#include "ecods/pose.hpp"
#include "simd/vec.hpp"

namespace ecods {

using Double2 = Vec<double, 2>;
using Double4 = Vec<double, 4>;

}  // namespace ecods

#define ECODS_TEXT "bounds/double4_text.hpp"
#include "simd/each_set.hpp"
