// The distance of two posed triangles in rational numbers, from its definition: every pair of features, each pair on
// its own. Slow, and shared with nothing.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "ecods/pose.hpp"
#include "exact/measure/feature_pair.hpp"
#include "scenes/hard_pairs.hpp"

namespace ecods::exact {

using RationalPoint = std::array<mpq_class, 3>;

inline RationalPoint rational(const Pose& pose, const Vec3& v) {
    RationalPoint result;
    for (int row = 0; row < 3; ++row) {
        mpq_class& x = result[static_cast<std::size_t>(row)];
        x = mpq_class(pose.t[row]);
        for (int k = 0; k < 3; ++k) x += mpq_class(pose.R(row, k)) * mpq_class(v[k]);
    }
    return result;
}

inline RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalPoint operator+(const RationalPoint& a, const RationalPoint& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline RationalPoint operator*(const mpq_class& s, const RationalPoint& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Points of two features, each in its relative interior, that no others of these features are nearer than.
struct FeatureDistance {
    FeaturePair features;
    RationalPoint p, q;
    mpq_class square;
};

struct RationalDistance {
    mpq_class square;  // of the distance
    std::vector<FeatureDistance>
        closest;  // the features that have it, in the order of the rule; none if they intersect
};

class RationalTriangles {
  public:
    RationalTriangles(const scenes::PosedPair& pair) {
        for (std::size_t i = 0; i < 3; ++i) {
            x_[0][i] = rational(pair.pose_a, pair.a[i]);
            x_[1][i] = rational(pair.pose_b, pair.b[i]);
        }
    }

    RationalDistance distance() {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) add(FeatureKind::vertex_vertex, 0, i, j, x_[0][i], x_[1][j]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                vertex_edge(0, i, j);
                vertex_edge(1, j, i);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                if (j == 0) vertex_face(0, i);
                if (i == 0) vertex_face(1, j);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) edge_edge(i, j);
        }
        RationalDistance result{all_.front().square, {}};
        for (const FeatureDistance& f : all_) result.square = std::min(result.square, f.square);
        if (edge_meets_face(0) || edge_meets_face(1)) result.square = 0;
        if (result.square == 0) return result;
        for (const FeatureDistance& f : all_) {
            if (f.square == result.square) result.closest.push_back(f);
        }
        return result;
    }

    const RationalPoint& corner(std::size_t side, std::size_t i) const { return x_[side][i % 3]; }

  private:
    void add(FeatureKind kind, std::size_t side, std::size_t i, std::size_t j, const RationalPoint& p,
             const RationalPoint& q) {
        const RationalPoint z = q - p;
        all_.push_back(
            {{kind, static_cast<std::uint8_t>(side), static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)},
             p,
             q,
             dot(z, z)});
    }
    void vertex_edge(std::size_t side, std::size_t vertex, std::size_t edge) {
        const RationalPoint &p = x_[side][vertex], &from = corner(1 - side, edge);
        const RationalPoint u = corner(1 - side, edge + 1) - from;
        const mpq_class uu = dot(u, u);
        if (uu == 0) return;
        const mpq_class t = dot(p - from, u) / uu;
        if (t <= 0 || t >= 1) return;
        const RationalPoint q = from + t * u;
        if (side == 0) add(FeatureKind::vertex_edge, 0, vertex, edge, p, q);
        if (side == 1) add(FeatureKind::vertex_edge, 1, edge, vertex, q, p);
    }
    // The weights of corners 1 and 2 of the foot of a point on a face, if it has one inside.
    std::optional<std::array<mpq_class, 2>> foot(std::size_t face, const RationalPoint& p, bool closed) const {
        const RationalPoint e1 = x_[face][1] - x_[face][0], e2 = x_[face][2] - x_[face][0], n = cross(e1, e2);
        const mpq_class nn = dot(n, n);
        if (nn == 0) return std::nullopt;
        const RationalPoint r = p - x_[face][0];
        const mpq_class s = dot(cross(r, e2), n) / nn, t = dot(cross(e1, r), n) / nn, rest = 1 - s - t;
        const bool is_inside = closed ? s >= 0 && t >= 0 && rest >= 0 : s > 0 && t > 0 && rest > 0;
        if (!is_inside) return std::nullopt;
        return std::array<mpq_class, 2>{s, t};
    }
    void vertex_face(std::size_t side, std::size_t vertex) {
        const std::size_t face = 1 - side;
        const RationalPoint& p = x_[side][vertex];
        const auto weights = foot(face, p, false);
        if (!weights) return;
        const RationalPoint q =
            x_[face][0] + (*weights)[0] * (x_[face][1] - x_[face][0]) + (*weights)[1] * (x_[face][2] - x_[face][0]);
        if (side == 0) add(FeatureKind::vertex_face, 0, vertex, 0, p, q);
        if (side == 1) add(FeatureKind::vertex_face, 1, 0, vertex, q, p);
    }
    void edge_edge(std::size_t i, std::size_t j) {
        const RationalPoint u = corner(0, i + 1) - corner(0, i), v = corner(1, j + 1) - corner(1, j);
        const RationalPoint n = cross(u, v), w = corner(1, j) - corner(0, i);
        const mpq_class nn = dot(n, n);
        if (nn == 0) return;
        const mpq_class s = dot(cross(w, v), n) / nn, t = dot(cross(w, u), n) / nn;
        if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return;
        add(FeatureKind::edge_edge, 0, i, j, corner(0, i) + s * u, corner(1, j) + t * v);
    }
    // Whether an edge of the other triangle has a point in the plane of a proper face that is in the face. Edges in the
    // plane are left to the feet of their ends and to crossing edges.
    bool edge_meets_face(std::size_t face) const {
        const RationalPoint n = cross(x_[face][1] - x_[face][0], x_[face][2] - x_[face][0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const RationalPoint &from = corner(1 - face, i), &to = corner(1 - face, i + 1);
            const mpq_class h = dot(from - x_[face][0], n), g = dot(to - x_[face][0], n);
            if (h == g || sgn(h) * sgn(g) > 0) continue;
            const mpq_class t = h / (h - g);
            if (foot(face, from + t * (to - from), true)) return true;
        }
        return false;
    }

    std::array<std::array<RationalPoint, 3>, 2> x_;
    std::vector<FeatureDistance> all_;
};

}  // namespace ecods::exact
