#include "bvh/axes/distance_axes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/outward.hpp"
#include "bvh/axes/posed_axes.hpp"

#define ECODS_TEXT "bvh/axes/distance_axes_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {
namespace {

constexpr double least_square = 0x1p-120;

}  // namespace

void DistanceAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) {
        unit_ = call_widest<ECODS_OF_EACH_SET(bind_distance_sets)>(sets_, a, b, d);
        return;
    }
    // Nothing is known about the nodes of an unbounded tree, so no pair is excluded.
    unit_ = 1;
    for (DistanceSet& set : sets_) {
        set = {};
        set.axes.set_unbounded();
    }
}

void PointAxes::bind(const PosedTree& tree, const Vec3& d) {
    are_useful_ = tree.tree.frame.is_bounded;
    if (!are_useful_) return;
    unit_ = call_widest<ECODS_OF_EACH_SET(bind_point_set)>(set_, tree, d);
    are_useful_ = is_near(set_) && set_.axes.point_error[0] < std::numeric_limits<float>::infinity();
}

bool is_near(const DistanceSet& set) noexcept {
    const auto& shift = set.axes.b.shift;
    const float most = std::max({std::abs(shift[0]), std::abs(shift[1]), std::abs(shift[2])});
    return !(most * std::sqrt(set.square) > static_cast<float>(far_min));
}

// 1 + 2^-48 covers four roundings of u' each.
// Claim: verify/proofs/small_bounds.py
float square_above(double distance, double unit) noexcept {
    const double x = distance / unit;
    return round_up(x * x * (1 + 0x1p-48) + least_square);
}

double DistanceAxes::distance_below(float square) const noexcept {
    const double certain = static_cast<double>(square) - least_square;
    return certain > 0 ? std::sqrt(certain) * (1 - 0x1p-48) * unit_ : 0;
}

// Adds the errors that triangle_bounds_text.hpp derives: 9 E, where E is the error bound of a corner, and 4 v = 4 *
// 2^-23 of the length. Underflow of the square is below E.
double distance_above(const DistanceSet& set, float square, double unit) noexcept {
    const auto& errors = set.axes.point_error;
    const double error = 9 * static_cast<double>(std::max({errors[0], errors[1], errors[2]}));
    const double length = std::sqrt(static_cast<double>(square)) * (1 + 0x1p-20) + error;
    return length * std::sqrt(static_cast<double>(set.square_up)) * (1 + 0x1p-40) * unit;
}

}  // namespace ecods
