// The vertices of a hull in the layout in which support points are searched for.
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

    // Coordinates are those of the mesh times 2^-exponent: the largest is at least 1/2 and below 1, and those below
    // 2^-900 are zero. By groups of four vertices: their x, their y, their z. The number of groups is even: the last
    // vertex fills them up.
    std::vector<double> groups;
    std::uint32_t vertex_count = 0;
    int exponent = 0;
    bool has_all_digits = true;  // whether no coordinate became zero

    exact::Point reach{};   // by axis: no magnitude is larger
    exact::Point extent{};  // by axis: no difference of two is larger
    exact::Point center{};  // of their box, about
    // Vertices that are furthest along and against each axis: where a climb begins that knows no better.
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

// x 2^exponent if that is at least 2^-900 in magnitude, otherwise 0. It must be below 2^900. Nothing is rounded, and no
// subnormal taken for zero.
double times_power(double x, int exponent) noexcept;

// The least e for which 2^e is above the magnitude of x; less than that of any other number if x is zero.
int exponent_above(double x) noexcept;

}  // namespace ecods::convex
