// A third implementation of the relation of two triangles, to judge the oracle: by clipping, in GMP's rational numbers.
// It shares one theorem with the oracle, and no code with anything, the linear programs of convex_pair.hpp included; it
// is quick enough for hundreds of thousands of pairs.
//
// A triangle, a segment and a point each are the points x at which some affine functions are not negative. The corners
// of one body are clipped by the functions of the other (Sutherland and Hodgman, Reentrant polygon clipping, CACM
// 1974); what is left is the common part, as a list of points that span it. If the relative interiors of two convex
// sets share a point, the relative interior of their common part lies in both (Rockafellar, Convex Analysis,
// theorem 6.5): so the mean of the list tells whether they do.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <vector>

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::oracle::clipping {

using Number = mpq_class;
using Point = std::array<Number, 3>;

inline Point posed(const Pose& pose, const Vec3& v) {
    Point point;
    for (int row = 0; row < 3; ++row) {
        Number& x = point[static_cast<std::size_t>(row)];
        x = Number(pose.t[row]);
        for (int k = 0; k < 3; ++k) x += Number(pose.R(row, k)) * Number(v[k]);
    }
    return point;
}

inline Point minus(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Number dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Point& a) {
    return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

// direction . (x - origin) >= 0; for a function that is zero on the whole body, its negative is here, too.
struct Bound {
    Point direction;
    Point origin;
    bool is_side;  // zero on part of the body only: positive in the relative interior

    Number at(const Point& x) const { return dot(direction, minus(x, origin)); }
};
using Bounds = std::vector<Bound>;

inline void add_both(Bounds& bounds, const Point& direction, const Point& origin) {
    bounds.push_back({direction, origin, false});
    bounds.push_back({{-direction[0], -direction[1], -direction[2]}, origin, false});
}

// Two of the points are the ends; the third lies between them.
inline void add_segment(Bounds& bounds, const std::array<Point, 3>& p) {
    std::size_t longest = 0;
    std::array<Number, 3> squares;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point edge = minus(p[(k + 1) % 3], p[k]);
        squares[k] = dot(edge, edge);
        if (squares[k] > squares[longest]) longest = k;
    }
    const Point &from = p[longest], &to = p[(longest + 1) % 3];
    const Point d = minus(to, from);
    // Of the three components of d x (x - from) two that are independent would do.
    add_both(bounds, {0, -d[2], d[1]}, from);
    add_both(bounds, {d[2], 0, -d[0]}, from);
    add_both(bounds, {-d[1], d[0], 0}, from);
    bounds.push_back({d, from, true});
    bounds.push_back({{-d[0], -d[1], -d[2]}, to, true});
}

inline Bounds bounds_of(const std::array<Point, 3>& p) {
    Bounds bounds;
    const Point normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    if (!is_zero(normal)) {
        add_both(bounds, normal, p[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            bounds.push_back({cross(normal, minus(p[(k + 1) % 3], p[k])), p[k], true});
        }
    } else if (is_zero(minus(p[1], p[0])) && is_zero(minus(p[2], p[0]))) {
        for (std::size_t k = 0; k < 3; ++k) {
            Point axis{0, 0, 0};
            axis[k] = 1;
            add_both(bounds, axis, p[0]);
        }
    } else {
        add_segment(bounds, p);
    }
    return bounds;
}

// The part of a convex polygon, a segment or a point, given by its corners in order, that a bound leaves.
inline std::vector<Point> clip(const std::vector<Point>& corners, const Bound& bound) {
    std::vector<Point> left;
    std::vector<Number> values;
    for (const Point& p : corners) values.push_back(bound.at(p));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t j = (i + 1) % corners.size();
        if (values[i] >= 0) left.push_back(corners[i]);
        if (sgn(values[i]) * sgn(values[j]) < 0) {
            const Number share = values[i] / (values[i] - values[j]);
            const Point step = minus(corners[j], corners[i]);
            Point& p = left.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) p[k] = corners[i][k] + share * step[k];
        }
    }
    return left;
}

inline bool is_in_relative_interior(const Point& x, const Bounds& bounds) {
    for (const Bound& bound : bounds) {
        const Number value = bound.at(x);
        if (bound.is_side ? value <= 0 : value != 0) return false;
    }
    return true;
}

inline bool are_coplanar(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    std::vector<Point> edges;
    for (const auto* triangle : {&a, &b}) {
        for (const Point& p : *triangle) edges.push_back(minus(p, a[0]));
    }
    for (const Point& u : edges) {
        for (const Point& v : edges) {
            const Point normal = cross(u, v);
            for (const Point& w : edges) {
                if (dot(normal, w) != 0) return false;
            }
        }
    }
    return true;
}

inline Relation relation(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    std::vector<Point> common(a.begin(), a.end());
    const Bounds bounds_b = bounds_of(b);
    for (const Bound& bound : bounds_b) {
        common = clip(common, bound);
        if (common.empty()) return Relation::apart;
    }
    Point mean{0, 0, 0};
    for (const Point& p : common) {
        for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<unsigned long>(common.size());
    }
    const bool is_inner = is_in_relative_interior(mean, bounds_b) && is_in_relative_interior(mean, bounds_of(a));
    return is_inner && !are_coplanar(a, b) ? Relation::crossing : Relation::touching;
}

inline Relation relation(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
                         const std::array<Vec3, 3>& b) {
    return relation({posed(pose_a, a[0]), posed(pose_a, a[1]), posed(pose_a, a[2])},
                    {posed(pose_b, b[0]), posed(pose_b, b[1]), posed(pose_b, b[2])});
}

}  // namespace ecods::oracle::clipping
