// triangle_contact decides from signs alone (exact/sign/exact_signs.hpp) if two triangles share more than one point,
// and along which of their features. Points 0 to 2 are the corners of the first triangle, 3 to 5 the corners of the
// second.
//
// Triangles in two planes share the intersection of their intervals on the line of the planes (triangle_pair.hpp). The
// intersection is a segment if and only if both comparisons there are strict and neither interval is a single corner.
// An interval is a single corner if this corner is in the other's plane and the other two corners are strictly on one
// side of it. The whole segment lies on a side of a triangle if both ends of that side are in the other's plane.
// Otherwise it is inside the triangle.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "base/assert.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods::exact {

enum class ContactKind : std::uint8_t {
    none,      // they share no point
    point,     // they share one point
    segment,   // they share one segment, and are in two planes
    coplanar,  // they are in one plane
    flat,      // the first triangle has no area and is not in the second's plane
};

struct TriangleContact {
    static constexpr int face = -1;

    ContactKind kind = ContactKind::none;
    // `first` and `second` are set only for a segment. `first` is the side of the first triangle on which the segment
    // lies, named by its first corner, or `face` if it lies inside the triangle. `second` is the same for the second
    // triangle.
    int first = face;
    int second = face;
};

// Returns the side, named by its first corner, whose ends are both in the plane (sign 0); `face` if there is none.
inline int side_in_plane(const Sides& s) noexcept {
    for (std::size_t i = 0; i < 3; ++i) {
        if (s[i] == 0 && s[(i + 1) % 3] == 0) return static_cast<int>(i);
    }
    return TriangleContact::face;
}

// Returns true if exactly one corner is in the plane, and the other two are strictly on the same side of it.
inline bool is_single_corner(const Sides& s) noexcept {
    return (s[0] == 0) + (s[1] == 0) + (s[2] == 0) == 1 && !strictly_on_both(s);
}

// Returns the contact of two triangles. The second triangle must have an area. If the first triangle has no area, the
// result is none, coplanar or flat.
template <class Signs>
TriangleContact triangle_contact(Signs& signs) {
    const Sides first = signs.sides(3, 0);
    if (all_positive(first) || all_negative(first)) return {};
    if (all_zero(first)) return {ContactKind::coplanar};
    const Sides second = signs.sides(0, 3);
    if (all_positive(second) || all_negative(second)) return {};
    if (all_zero(second)) return {ContactKind::flat};

    const EdgeComparison e = name_corners(first, second);
    const int begin = signs.orient3d(e.q1, e.p2, e.p1, e.q2);
    if (begin > 0) return {};
    const int end = signs.orient3d(e.p1, e.p2, e.r1, e.r2);
    if (end > 0) return {};
    if (begin == 0 || end == 0 || is_single_corner(first) || is_single_corner(second)) return {ContactKind::point};
    return {ContactKind::segment, side_in_plane(first), side_in_plane(second)};
}

// Returns true if two triangles in one plane share an inner point: no side of either has the other triangle entirely
// beyond or on its line. The plane's normal must not be zero on `axis`: the two are projected along it.
template <class Signs>
bool coplanar_faces_overlap(Signs& signs, int axis) {
    for (const int own : {0, 3}) {
        const int other = 3 - own;
        const int turn = signs.orient2d(own, own + 1, own + 2, axis);
        for (int side = 0; side < 3; ++side) {
            bool is_outside = true;
            for (int corner = 0; corner < 3 && is_outside; ++corner) {
                is_outside = signs.orient2d(own + side, own + (side + 1) % 3, other + corner, axis) * turn <= 0;
            }
            if (is_outside) return false;
        }
    }
    return true;
}

// Returns true if the segments pq and rs are on one line and share more than one point. They must be in one plane,
// whose normal is not zero on `normal_axis`. Points of the line are ordered by their coordinates on the first axis on
// which p and q differ.
template <class Signs>
bool segments_lie_along(Signs& signs, int p, int q, int r, int s, int normal_axis) {
    if (signs.orient2d(p, q, r, normal_axis) != 0 || signs.orient2d(p, q, s, normal_axis) != 0) return false;
    int axis = 0;
    while (axis < 2 && signs.compare(p, q, axis) == 0) ++axis;
    const auto order = [&](int& low, int& high) {
        if (signs.compare(low, high, axis) > 0) std::swap(low, high);
    };
    order(p, q);
    order(r, s);
    return signs.compare(p, s, axis) < 0 && signs.compare(r, q, axis) < 0;
}

}  // namespace ecods::exact
