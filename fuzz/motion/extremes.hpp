// Moves to the ends of the range of doubles, and beyond: sizes far apart, products that overflow or underflow.
#pragma once

#include <span>

#include "fuzz/motion/poses.hpp"

namespace ecods::fuzz {

// The size of a mesh of a scene of extremes: a power of two, from the smallest subnormals to the largest numbers.
double extreme_unit(scenes::Random& random);

std::span<const Move> extreme_moves();

}  // namespace ecods::fuzz
