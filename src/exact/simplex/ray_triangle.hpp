// Rays along a coordinate axis are tested against a triangle, from signs alone (exact/sign/exact_signs.hpp). Points 0
// to 2 are the triangle's corners. A ray that would meet a side or a corner is displaced symbolically.
//
// The triangle's shadow is its projection along the axis. It is a triangle of the plane, unless the triangle is
// parallel to the axis; then a ray in general position misses it. The ray begins at a point m that is not on the
// triangle. m is displaced by so little that only signs change that were zero. After that, m is either in the open
// shadow or outside of the closed one. The ray crosses the triangle if and only if m is in the shadow and the triangle
// is in front of m. If the shadow turns left, a positive orient3d(0, 1, 2, m) means that m is above the triangle as
// seen along the axis; if it turns right, below.
#pragma once

#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/segment_pair.hpp"

namespace ecods::exact {

// A RayDirection is a ray's axis, 0 to 2, and the direction along the axis: 1 for up, -1 for down.
struct RayDirection {
    int axis = 0;
    int sign = 1;
};

// A PointFeature is the open feature of a triangle that contains a given point; `none` if the point is not on the
// triangle.
struct PointFeature {
    enum class Kind : std::uint8_t { none, vertex, edge, face };

    Kind kind = Kind::none;
    int corner = 0;  // the vertex, or the first corner of the edge
};

// Returns the feature of the triangle (points 0 to 2) that contains point 3. The triangle may have no area.
template <class Signs>
PointFeature feature_at(Signs& signs) {
    using Kind = PointFeature::Kind;
    for (int corner = 0; corner < 3; ++corner) {
        if (compare_lexicographically(signs, corner, 3) == 0) return {Kind::vertex, corner};
    }
    for (int corner = 0; corner < 3; ++corner) {
        const Segment side{corner, (corner + 1) % 3};
        if (compare_lexicographically(signs, side.a, side.b) != 0 && is_on_segment(signs, 3, side)) {
            return {Kind::edge, corner};
        }
    }
    const int axis = signs.normal_axis(0);
    if (axis < 0 || signs.orient3d(0, 1, 2, 3) != 0) return {};
    const int turn = signs.orient2d(0, 1, 2, axis);
    for (int corner = 0; corner < 3; ++corner) {
        if (signs.orient2d(corner, (corner + 1) % 3, 3, axis) * turn <= 0) return {};
    }
    return {Kind::face, 0};
}

// Returns true if the ray from m crosses the triangle. in_shadow(a, b) returns the sign of orient2d(a, b, m) along the
// ray's axis, and above() the sign of orient3d(0, 1, 2, m). Neither may be zero.
template <class Signs, class InShadow, class Above>
bool crosses(Signs& signs, RayDirection ray, InShadow&& in_shadow, Above&& above) {
    const int turn = signs.orient2d(0, 1, 2, ray.axis);
    if (turn == 0) return false;
    for (int corner = 0; corner < 3; ++corner) {
        if (in_shadow(corner, (corner + 1) % 3) != turn) return false;
    }
    return above() * turn * ray.sign < 0;
}

// Returns true if the ray from p crosses the triangle. p is point 3, and must not be on the triangle. The ray begins at
// m = p + d e_i + d^2 e_j for the other two axes i and j and an infinitesimal d > 0. orient2d(a, b, m) is (b_i -
// a_i)(m_j - a_j) - (b_j - a_j)(m_i - a_i). If it is 0 for p, its change has the sign of a_j - b_j or, if that is zero,
// of b_i - a_i.
template <class Signs>
bool ray_crosses(Signs& signs, RayDirection ray) {
    const int i = (ray.axis + 1) % 3, j = (ray.axis + 2) % 3;
    const auto in_shadow = [&](int a, int b) {
        if (const int s = signs.orient2d(a, b, 3, ray.axis)) return s;
        if (const int s = signs.compare(a, b, j)) return s;
        return signs.compare(b, a, i);
    };
    return crosses(signs, ray, in_shadow, [&] { return signs.orient3d(0, 1, 2, 3); });
}

// Returns true if a ray that begins inside a second triangle crosses the triangle. The second triangle has the corners
// p, q and r, points 3, 4 and 5, and the ray begins at m = p + d (q - p) + d^2 (r - p) for an infinitesimal d > 0. A
// function that is affine in m has the sign of the first of its values at p, q and r that is not zero.
template <class Signs>
bool inner_ray_crosses(Signs& signs, RayDirection ray) {
    const auto in_shadow = [&](int a, int b) {
        if (const int s = signs.orient2d(a, b, 3, ray.axis)) return s;
        if (const int s = signs.orient2d(a, b, 4, ray.axis)) return s;
        return signs.orient2d(a, b, 5, ray.axis);
    };
    const auto above = [&] {
        const Sides sides = signs.sides(0, 3);
        return sides[0] != 0 ? sides[0] : sides[1] != 0 ? sides[1] : sides[2];
    };
    return crosses(signs, ray, in_shadow, above);
}

// RayContact classifies how a ray meets a triangle of positive area.
enum class RayContact : std::uint8_t {
    misses,
    crosses,
    begins_on,
};

// Returns how the ray from m = p + d (q - p) + d^2 (r - p) + d^3 e_i + d^4 e_j meets the triangle; d > 0 is
// infinitesimal, and p, q and r are points 3, 4 and 5. p, q and r may be equal or on one line: for q = r, m is beside p
// on the way to q.
//
// Let m' be m without the last two terms. The ray begins on the triangle if m' is on it. Otherwise m' may be in the
// triangle's plane and beside the triangle: then the ray misses it. Or m' is not in the plane: then the last two terms
// leave m on the same side of the plane, and displace its shadow from the lines of the triangle's sides.
template <class Signs>
RayContact moved_ray_contact(Signs& signs, RayDirection ray) {
    const auto first_sign = [](auto&& at) {
        for (int point = 3; point < 6; ++point) {
            if (const int s = at(point)) return s;
        }
        return 0;
    };
    const int side = first_sign([&](int point) { return signs.orient3d(0, 1, 2, point); });
    if (side == 0) {
        const int axis = signs.normal_axis(0);
        if (axis < 0) return RayContact::misses;  // no area
        const int turn = signs.orient2d(0, 1, 2, axis);
        for (int a = 0; a < 3; ++a) {
            const int s = first_sign([&](int point) { return signs.orient2d(a, (a + 1) % 3, point, axis); });
            if (s * turn < 0) return RayContact::misses;
        }
        return RayContact::begins_on;
    }
    const int i = (ray.axis + 1) % 3, j = (ray.axis + 2) % 3;
    const auto in_shadow = [&](int a, int b) {
        if (const int s = first_sign([&](int point) { return signs.orient2d(a, b, point, ray.axis); })) return s;
        if (const int s = signs.compare(a, b, j)) return s;
        return signs.compare(b, a, i);
    };
    return crosses(signs, ray, in_shadow, [&] { return side; }) ? RayContact::crosses : RayContact::misses;
}

}  // namespace ecods::exact
