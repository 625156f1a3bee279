// An ExactPoint is a point with rational coordinates; round_point() rounds each coordinate once.
#pragma once

#include <array>

#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/natural.hpp"
#include "exact/point/posed_points.hpp"

namespace ecods::exact {

// An ExactPoint has the coordinates num / den * 2^unit, relative to the first corner of the first triangle. A numerator
// has the length of five coordinates: it is a sum of products of a weight (four) and a difference (one).
struct ExactPoint {
    struct Coordinate {
        Natural<5 * limb_count_max> size;
        bool is_negative = false;
    };
    std::array<Coordinate, 3> num;
    Natural<denominator_limbs> den{1};
    int unit = 0;
};

// Returns `point`, which is relative to the corner `origin`, in world coordinates, each rounded once to the nearest
// double, ties to even; a zero is +0.
Vec3 round_point(const PointRef& origin, const ExactPoint& point) noexcept;
double round_coordinate(const PointRef& origin, int row, const ExactPoint& point) noexcept;  // one of its numbers

// Returns true if coordinate `axis` of a and b, points in one unit, is the same number.
bool is_level(const ExactPoint& a, const ExactPoint& b, std::size_t axis);

// Returns the middle of two points in one unit. The points' denominators must be equal, or one of them must be 1: then
// the bound of the middle's numerators is only one bit longer than the bound of the points' numerators.
ExactPoint middle_of(const ExactPoint& a, const ExactPoint& b);

}  // namespace ecods::exact
