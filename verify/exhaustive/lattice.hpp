// All triangles with corners in {0, 1, 2}^3, and the symmetries of that cube.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/pose.hpp"

namespace ecods::lattice {

inline constexpr int point_count = 27;

// The point of a number in 0 to 26, by its digits in base 3.
std::array<int, 3> digits(int point);
Vec3 position(int point);

// Three point numbers, ascending; equal numbers for zero-area triangles that repeat a corner.
using Corners = std::array<int, 3>;
std::array<Vec3, 3> positions(const Corners& corners);

// Every triple of points with repetition: 2,876 proper triangles, 49 of three collinear points, 702 with two equal
// corners, 27 with three.
std::vector<Corners> all_triangles();

// A symmetry as a permutation of the 27 points; there are 48.
using Symmetry = std::array<int, point_count>;
std::vector<Symmetry> all_symmetries();

// The image of a triangle, corners ascending again.
Corners apply(const Symmetry& symmetry, const Corners& corners);

}  // namespace ecods::lattice
