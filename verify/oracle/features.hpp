// Distances of features of two triangles in the numbers of a template: integers, or intervals that enclose them.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>

#include "oracle/exact_point.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

// Squares are not negative, which products of intervals do not know.
inline mpz_class square(const mpz_class& x) {
    return x * x;
}
inline Interval square(const Interval& x) {
    return CGAL::square(x);
}
template <class N>
N square_of(const Vector<N>& v) {
    return square(v[0]) + square(v[1]) + square(v[2]);
}

inline bool may_be_positive(const mpz_class& x) {
    return sgn(x) > 0;
}
inline bool is_positive(const mpz_class& x) {
    return sgn(x) > 0;
}
inline bool may_be_positive(const Interval& x) {
    return !(x.sup() <= 0);
}
inline bool is_positive(const Interval& x) {
    return x.inf() > 0;
}
inline bool may_be_zero(const mpz_class& x) {
    return sgn(x) == 0;
}
inline bool may_be_zero(const Interval& x) {
    return !(x.inf() > 0 || x.sup() < 0);
}

// A triangle with what is made of its corners: edge i goes from corner i to the next one.
template <class N>
struct TriangleOf {
    std::array<Vector<N>, 3> corner;
    std::array<Vector<N>, 3> edge;
    std::array<N, 3> edge_square;
    Vector<N> normal;
    N normal_square;

    explicit TriangleOf(const std::array<Vector<N>, 3>& corners) : corner(corners) {
        for (std::size_t i = 0; i < 3; ++i) {
            edge[i] = corner[(i + 1) % 3] - corner[i];
            edge_square[i] = square_of(edge[i]);
        }
        normal = cross(edge[0], corner[2] - corner[0]);
        normal_square = square_of(normal);
    }
};

// The distance of two features is the root of num / den where `is_inside`: where the closest points of what they span
// (a point, a line, a plane) are inside both, an edge without its ends and a face without its edges, and are the only
// ones.
template <class N>
struct FeatureDistance {
    bool is_inside = false;      // for intervals: surely
    bool may_be_inside = false;  // for integers: the same
    N num, den;
    // Where the point is, in units of den: along the edge of a, along the edge of b; above the face.
    N along_a, along_b, above;
};

template <class N>
FeatureDistance<N> vertex_vertex(const Vector<N>& p, const Vector<N>& q) {
    return {true, true, square_of(Vector<N>(q - p)), N(1), N(0), N(0), N(0)};
}

// The edge is edge e of t.
template <class N>
FeatureDistance<N> vertex_edge(const Vector<N>& p, const TriangleOf<N>& t, std::size_t e) {
    FeatureDistance<N> d;
    const Vector<N> w = p - t.corner[e];
    const N& length = t.edge_square[e];
    d.along_b = dot(w, t.edge[e]);
    const N rest = length - d.along_b;
    d.may_be_inside = may_be_positive(d.along_b) && may_be_positive(rest);
    if (!d.may_be_inside) return d;
    d.is_inside = is_positive(d.along_b) && is_positive(rest);
    d.num = square_of(cross(w, t.edge[e]));
    d.den = length;
    return d;
}

template <class N>
FeatureDistance<N> vertex_face(const Vector<N>& p, const TriangleOf<N>& t) {
    FeatureDistance<N> d;
    if (!may_be_positive(t.normal_square)) return d;
    d.is_inside = is_positive(t.normal_square);
    d.may_be_inside = true;
    for (std::size_t i = 0; i < 3 && d.may_be_inside; ++i) {
        const N side = dot(cross(t.edge[i], p - t.corner[i]), t.normal);
        d.may_be_inside = may_be_positive(side);
        d.is_inside = d.is_inside && is_positive(side);
    }
    if (!d.may_be_inside) return d;
    d.above = dot(t.normal, p - t.corner[0]);
    d.num = square(d.above);
    d.den = t.normal_square;
    return d;
}

// Edge i of s and edge j of t.
template <class N>
FeatureDistance<N> edge_edge(const TriangleOf<N>& s, std::size_t i, const TriangleOf<N>& t, std::size_t j) {
    FeatureDistance<N> d;
    const Vector<N>& u = s.edge[i];
    const Vector<N>& v = t.edge[j];
    const Vector<N> n = cross(u, v);
    d.den = square_of(n);
    if (!may_be_positive(d.den)) return d;
    const Vector<N> w = t.corner[j] - s.corner[i];
    d.along_a = dot(cross(w, v), n);
    const N rest_a = d.den - d.along_a;
    if (!may_be_positive(d.along_a) || !may_be_positive(rest_a)) return d;
    d.along_b = dot(cross(w, u), n);
    const N rest_b = d.den - d.along_b;
    if (!may_be_positive(d.along_b) || !may_be_positive(rest_b)) return d;
    d.may_be_inside = true;
    d.is_inside = is_positive(d.den) && is_positive(d.along_a) && is_positive(rest_a) && is_positive(d.along_b) &&
                  is_positive(rest_b);
    d.num = square(dot(n, w));
    return d;
}

// Whether the line of edge i of s may pass through the closed face of t, its ends on either side of the plane, neither
// in it. Heights of the ends above the face, times the length of its normal.
template <class N>
struct Piercing {
    bool may_be = false;
    N height_from, height_to;
};

template <class N>
Piercing<N> pierces(const TriangleOf<N>& s, std::size_t i, const TriangleOf<N>& t) {
    Piercing<N> result;
    const Vector<N> from = s.corner[i] - t.corner[0];
    const Vector<N> to = s.corner[(i + 1) % 3] - t.corner[0];
    result.height_from = dot(t.normal, from);
    result.height_to = dot(t.normal, to);
    const N minus_from = -result.height_from, minus_to = -result.height_to;
    const bool downwards = may_be_positive(result.height_from) && may_be_positive(minus_to);
    const bool upwards = may_be_positive(minus_from) && may_be_positive(result.height_to);
    if (!downwards && !upwards) return result;
    bool may_be_left = true, may_be_right = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const N side = dot(s.edge[i], cross(t.corner[k] - s.corner[i], t.corner[(k + 1) % 3] - s.corner[i]));
        const N minus_side = -side;
        may_be_left = may_be_left && (may_be_positive(side) || may_be_zero(side));
        may_be_right = may_be_right && (may_be_positive(minus_side) || may_be_zero(side));
    }
    result.may_be = may_be_left || may_be_right;
    return result;
}

}  // namespace ecods::oracle
