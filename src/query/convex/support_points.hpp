// Stores the vertices of a hull in the layout that searches for support points read.
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

    // Coordinates of the mesh times 2^-exponent: the largest one is at least 1/2 and below 1, and those below 2^-900
    // are zero. Each group of four vertices holds their x, their y, their z. The number of groups is even; copies of
    // the last vertex fill them up.
    std::vector<double> groups;
    std::uint32_t vertex_count = 0;
    int exponent = 0;
    bool has_all_digits = true;  // true if no coordinate became zero

    exact::Point reach{};   // by axis: upper bound of magnitudes
    exact::Point extent{};  // by axis: upper bound of differences
    exact::Point center{};  // rounded center of their box
    // The extreme vertices against and along each axis, where a climb without a start begins.
    std::array<std::uint32_t, 6> extremes{};
    // By vertex of the mesh: its index in the hull, or none.
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> hull_index;

    exact::Point at(std::uint32_t vertex) const noexcept {
        const double* group = groups.data() + vertex / lanes * (3 * lanes) + vertex % lanes;
        return {group[0], group[lanes], group[2 * lanes]};
    }
};

SupportPoints make_support_points(const Mesh& mesh, const Hull& hull);

// x 2^exponent, exactly, if its magnitude is at least 2^-900; otherwise 0. It must be below 2^900. No subnormal is
// flushed to zero.
double times_power(double x, int exponent) noexcept;

// The least e with 2^e > |x|. For x = 0 it is less than for any other number.
int exponent_above(double x) noexcept;

}  // namespace ecods::convex
