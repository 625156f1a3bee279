// SupportPoints stores the vertices of a hull in the layout in which searches for support points read them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "exact/point/point.hpp"
#include "query/convex/hull.hpp"

namespace ecods::convex {

struct SupportPoints {
    static constexpr std::size_t lanes = 4;

    // Holds the coordinates of the mesh times 2^-exponent. The exponent is such that the largest magnitude is at least
    // 1/2 and below 1. Coordinates below 2^-900 are replaced by zero. A group has four vertices: their x, then their y,
    // then their z. The number of groups is even; copies of the last vertex fill them up.
    std::vector<double> groups;
    std::uint32_t vertex_count = 0;
    int exponent = 0;
    bool has_all_digits = true;  // true if no nonzero coordinate was replaced by zero

    exact::Point reach{};   // by axis: upper bound of the magnitudes of coordinates
    exact::Point extent{};  // by axis: upper bound of the differences of coordinates
    exact::Point center{};  // center of the vertices' box, rounded
    // Lists, by axis, the two vertices that are extreme against and along the axis. A climb without a start begins at
    // one of these vertices.
    std::array<std::uint32_t, 6> extremes{};
    // Stands in hull_index for a vertex of the mesh that is no vertex of the hull. hull_index has, by vertex of the
    // mesh, the index in the hull.
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> hull_index;

    exact::Point at(std::uint32_t vertex) const noexcept {
        const double* group = groups.data() + vertex / lanes * (3 * lanes) + vertex % lanes;
        return {group[0], group[lanes], group[2 * lanes]};
    }
};

SupportPoints make_support_points(const Mesh& mesh, const Hull& hull);

// Returns x 2^exponent, exactly, if its magnitude is at least 2^-900; otherwise 0. The result must be below 2^900. A
// subnormal x is not flushed to zero.
double times_power(double x, int exponent) noexcept;

// Returns the least e with 2^e > |x|. For x = 0 the result is less than for any other number.
int exponent_above(double x) noexcept;

}  // namespace ecods::convex
