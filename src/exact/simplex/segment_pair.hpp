// The functions of this file relate triangles of zero area as the segments or points that they span, from signs alone
// (triangle_pair.hpp). A triangle is named by the index of the first of its three corners.
#pragma once

#include <array>

#include "base/assert.hpp"
#include "ecods/primitives.hpp"

namespace ecods::exact {

// A Segment is named by the indices of its ends. The indices are equal if the segment is a point.
struct Segment {
    int a;
    int b;
};

// Returns the order of two points by x, then y, then z, as -1, 0 or 1. In this order, points of a line are sorted along
// the line.
template <class Signs>
int compare_lexicographically(Signs& signs, int a, int b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (const int order = signs.compare(a, b, axis)) return order;
    }
    return 0;
}

// Returns the segment or point that the triangle of zero area from corner `first` spans: its extreme corners.
template <class Signs>
Segment find_segment(Signs& signs, int first) {
    Segment s{first, first};
    for (int corner = first + 1; corner < first + 3; ++corner) {
        if (compare_lexicographically(signs, corner, s.a) < 0) s.a = corner;
        if (compare_lexicographically(signs, corner, s.b) > 0) s.b = corner;
    }
    if (compare_lexicographically(signs, s.a, s.b) == 0) s.b = s.a;
    return s;
}

// Returns true if p is on the closed segment: on its line (in all three projections), and not beyond an end.
template <class Signs>
bool is_on_segment(Signs& signs, int p, Segment s) {
    for (int axis = 0; axis < 3; ++axis) {
        if (signs.orient2d(s.a, s.b, p, axis) != 0) return false;
    }
    return compare_lexicographically(signs, p, s.a) * compare_lexicographically(signs, p, s.b) <= 0;
}

template <class Signs>
bool segments_meet(Signs& signs, Segment s, Segment t) {
    if (is_on_segment(signs, s.a, t) || is_on_segment(signs, s.b, t)) return true;
    if (is_on_segment(signs, t.a, s) || is_on_segment(signs, t.b, s)) return true;
    // No end is on the other segment, so the segments share a point only if they cross properly, in one plane.
    if (signs.orient3d(s.a, s.b, t.a, t.b) != 0) return false;
    // If a sign is not zero in a projection, the segments' plane is not seen edge-on, so it is projected one to one.
    // Then the segments cross properly if and only if they do so in this projection.
    for (int axis = 0; axis < 3; ++axis) {
        const int ta = signs.orient2d(s.a, s.b, t.a, axis), tb = signs.orient2d(s.a, s.b, t.b, axis);
        const int sa = signs.orient2d(t.a, t.b, s.a, axis), sb = signs.orient2d(t.a, t.b, s.b, axis);
        if (ta != 0 || tb != 0 || sa != 0 || sb != 0) return ta * tb < 0 && sa * sb < 0;
    }
    return false;
}

// Returns true if segment s meets the triangle from corner `first`. The segment must be in the triangle's plane, whose
// normal must not be zero on `axis`: the two are projected along it.
template <class Signs>
bool meets_in_plane(Signs& signs, Segment s, int first, int axis) {
    const int turn = signs.orient2d(first, first + 1, first + 2, axis);
    ECODS_ASSERT(turn != 0);
    const auto is_inside = [&](int p) {
        for (int edge = 0; edge < 3; ++edge) {
            if (signs.orient2d(first + edge, first + (edge + 1) % 3, p, axis) * turn < 0) return false;
        }
        return true;
    };
    if (is_inside(s.a) || is_inside(s.b)) return true;
    for (int edge = 0; edge < 3; ++edge) {
        if (segments_meet(signs, s, Segment{first + edge, first + (edge + 1) % 3})) return true;
    }
    return false;
}

// Returns the relation of a segment or point s and the triangle from corner `first`, which must have an area. The
// result is crossing if the open segment and the open triangle share exactly one point.
template <class Signs>
Relation segment_triangle(Signs& signs, Segment s, int first) {
    const int side_a = signs.orient3d(first, first + 1, first + 2, s.a);
    const int side_b = signs.orient3d(first, first + 1, first + 2, s.b);
    if (side_a * side_b > 0) return Relation::apart;
    if (side_a == 0 && side_b == 0) {
        const bool meets = meets_in_plane(signs, s, first, signs.normal_axis(first));
        return meets ? Relation::touching : Relation::apart;
    }
    // The segment's line meets the plane in one point of the segment. This point is in the closed triangle if and only
    // if the line does not pass two directed edges on different sides.
    bool positive = false, negative = false, zero = false;
    for (int edge = 0; edge < 3; ++edge) {
        const int side = signs.orient3d(s.a, s.b, first + edge, first + (edge + 1) % 3);
        positive |= side > 0;
        negative |= side < 0;
        zero |= side == 0;
    }
    if (positive && negative) return Relation::apart;
    return side_a * side_b < 0 && !zero ? Relation::crossing : Relation::touching;
}

// Returns the relation of two triangles, at least one of which has zero area. Two segments that meet are in one plane,
// so the result is touching.
template <class Signs>
Relation degenerate_pair(Signs& signs) {
    const bool first_is_flat = signs.normal_axis(0) < 0;
    const bool second_is_flat = signs.normal_axis(3) < 0;
    if (first_is_flat && second_is_flat) {
        const bool meet = segments_meet(signs, find_segment(signs, 0), find_segment(signs, 3));
        return meet ? Relation::touching : Relation::apart;
    }
    return first_is_flat ? segment_triangle(signs, find_segment(signs, 0), 3)
                         : segment_triangle(signs, find_segment(signs, 3), 0);
}

}  // namespace ecods::exact
