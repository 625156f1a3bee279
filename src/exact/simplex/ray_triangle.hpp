// Whether a ray along an axis crosses a triangle, from a point that is moved symbolically where it has to be. Decided
// from signs alone (exact/sign/exact_signs.hpp). Points 0 to 2 are the corners of the triangle.
//
// Seen along the axis, the triangle is its shadow, a triangle of the plane, unless it is parallel to the axis: then a
// ray that is moved in a general way misses it. The ray begins at a point m off the triangle, and m is moved so little
// that no sign changes but those that were zero: so m is in the open shadow, or off the closed one. It crosses the
// triangle exactly when it is in the shadow and the triangle is in front of it. Positive orient3d(0, 1, 2, m) says that
// m is above the triangle as seen along the axis if the shadow turns left, and below it if it turns right.
#pragma once

#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/segment_pair.hpp"

namespace ecods::exact {

// The axis, 0 to 2, and 1 or -1 for a ray that goes up or down on it.
struct RayDirection {
    int axis = 0;
    int sign = 1;
};

// The open feature of a triangle that holds a point.
struct PointFeature {
    enum class Kind : std::uint8_t { none, vertex, edge, face };

    Kind kind = Kind::none;
    int corner = 0;  // the vertex, or where the edge begins
};

// The feature of a triangle that may have no area which holds point 3.
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

// Whether the ray from `m` crosses the triangle; `in_shadow(a, b)` is the sign of orient2d(a, b, m) along its axis, and
// `above()` that of orient3d(0, 1, 2, m), neither of them zero.
template <class Signs, class InShadow, class Above>
bool crosses(Signs& signs, RayDirection ray, InShadow&& in_shadow, Above&& above) {
    const int turn = signs.orient2d(0, 1, 2, ray.axis);
    if (turn == 0) return false;
    for (int corner = 0; corner < 3; ++corner) {
        if (in_shadow(corner, (corner + 1) % 3) != turn) return false;
    }
    return above() * turn * ray.sign < 0;
}

// The ray from point 3, which is not on the triangle, with m = p + d e_i + d^2 e_j for the other two axes i and j and
// an infinitesimal d > 0. orient2d(a, b, m) is (b_i - a_i)(m_j - a_j) - (b_j - a_j)(m_i - a_i): where it is 0 for p,
// the sign of its change is that of a_j - b_j, and if that is zero, that of b_i - a_i.
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

// The ray from inside the triangle of points 3, 4 and 5, p, q and r, with m = p + d (q - p) + d^2 (r - p). Signs are
// those of functions that are affine in m: the first of their values at p, q and r that is not zero.
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

// What a ray does to a triangle of positive area.
enum class RayContact : std::uint8_t {
    misses,
    crosses,
    begins_on,
};

// The ray from m = p + d (q - p) + d^2 (r - p) + d^3 e_i + d^4 e_j, p, q and r being points 3, 4 and 5, which may be
// equal or on one line: for q = r, m is beside p on the way to q. It begins on the triangle if it does without the last
// two terms, which are there so that its shadow is off the lines of the triangle's sides. Where it does not, those do
// not change on which side of the triangle's plane m is: m is off the plane, or off the triangle's shadow.
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
