#include "exact/measure/distance/guess_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

using Index = std::size_t;

ECODS_ALWAYS_INLINE double clamp(double x) noexcept {
    return std::min(std::max(x, 0.0), 1.0);
}

// Returns the features that contain the points at parameter s of the first triangle's edge i and at t of the second's
// edge j.
FeaturePair features_at(Index i, double s, Index j, double t) noexcept {
    const bool is_inside_a = s > 0 && s<1, is_inside_b = t> 0 && t < 1;
    const Index a = s >= 1 ? next_corner(i) : i, b = t >= 1 ? next_corner(j) : j;
    if (is_inside_a && is_inside_b) return pair_of(FeatureKind::edge_edge, 0, i, j);
    if (is_inside_a) return pair_of(FeatureKind::vertex_edge, 1, i, b);
    if (is_inside_b) return pair_of(FeatureKind::vertex_edge, 0, a, j);
    return pair_of(FeatureKind::vertex_vertex, 0, a, b);
}

struct Candidate {
    double square = std::numeric_limits<double>::infinity();
    FeaturePair features;
};

class FeatureGuess {
  public:
    explicit FeatureGuess(const Points<6>& x) noexcept : x_(x), edge_(edges_of(x)) {
        for (Index i = 0; i < 3; ++i) {
            square_[0][i] = dot(edge_[0][i], edge_[0][i]);
            square_[1][i] = dot(edge_[1][i], edge_[1][i]);
        }
    }

    FeaturePair find() noexcept {
        if (try_face(0) || try_face(1)) return best_.features;
        for (Index i = 0; i < 3; ++i) {
            for (Index j = 0; j < 3; ++j) {
                if (try_edges((first_[0] + i) % 3, (first_[1] + j) % 3)) return best_.features;
            }
        }
        return best_.features;
    }

  private:
    // Computes the closest points of edges i and j, and stores their features in best_ if no nearer pair was found
    // before. Returns true if these points are very probably the closest points of the triangles.
    ECODS_ALWAYS_INLINE bool try_edges(Index i, Index j) noexcept {
        const Point &u = edge_[0][i], &v = edge_[1][j];
        const double uu = square_[0][i], vv = square_[1][j];
        const Point w = minus(x_[3 + j], x_[i]);
        const double uv = dot(u, v), wu = dot(w, u), wv = dot(w, v);
        const double denominator = uu * vv - uv * uv;
        double s = denominator > 0 ? clamp((wu * vv - wv * uv) / denominator) : 0;
        double t = vv > 0 ? (s * uv - wv) / vv : 0;
        if (!(t > 0 && t < 1)) {
            t = clamp(t);
            s = uu > 0 ? clamp((t * uv + wu) / uu) : 0;
        }
        Point z;
        for (Index k = 0; k < 3; ++k) z[k] = (w[k] + t * v[k]) - s * u[k];
        const double square = dot(z, z);
        if (!(square < best_.square)) return false;
        best_ = {square, features_at(i, s, j, t)};
        // third_a and third_b are the dot products of z with the vectors from the closest points to the third corners;
        // each vector goes along the edge to its end, (1 - s) u, and then along the next edge.
        const double third_a = dot(edge_[0][next_corner(i)], z) + (1 - s) * dot(u, z);
        const double third_b = dot(edge_[1][next_corner(j)], z) + (1 - t) * dot(v, z);
        return third_a <= 0 && third_b >= 0;
    }

    // Returns true if the plane of the face of triangle `side` separates the triangles, and the other triangle's corner
    // nearest to the plane is over the face; then sets best_ to that corner and the face. If the nearest corner is not
    // over the face, sets first_ to the edges to begin with: the face's edge beyond which the corner's foot is, and the
    // edge that begins at the nearest corner.
    ECODS_ALWAYS_INLINE bool try_face(Index side) noexcept {
        const Point *face = &x_[3 * side], *corners = &x_[3 * (1 - side)];
        const Point &e1 = edge_[side][0], e2 = minus(face[2], face[0]), n = cross(e1, e2);
        std::array<double, 3> h;
        for (Index i = 0; i < 3; ++i) h[i] = dot(minus(corners[i], face[0]), n);
        const bool is_above = h[0] > 0 && h[1] > 0 && h[2] > 0, is_below = h[0] < 0 && h[1] < 0 && h[2] < 0;
        if (!is_above && !is_below) return false;
        const Index nearest = least_of(std::abs(h[0]), std::abs(h[1]), std::abs(h[2]));
        const Point r = minus(corners[nearest], face[0]);
        const double b1 = dot(cross(r, e2), n), b2 = dot(cross(e1, r), n), b0 = (dot(n, n) - b1) - b2;
        if (b0 >= 0 && b1 >= 0 && b2 >= 0) {
            best_.features = vertex_and(FeatureKind::vertex_face, 1 - side, nearest, 0);
            return true;
        }
        first_[side] = least_of(b2, b0, b1);
        first_[1 - side] = nearest;
        return false;
    }

    const Points<6>& x_;
    TriangleEdges edge_;
    double square_[2][3];
    Candidate best_;
    Index first_[2] = {0, 0};
};

// Returns the features of a point and a triangle. `x` has the triangle's corners relative to the point.
FeaturePair guess_of_point(const Point* x) noexcept {
    const Point e1 = minus(x[1], x[0]), e2 = minus(x[2], x[0]), n = cross(e1, e2);
    const double b1 = dot(cross(e2, x[0]), n), b2 = dot(cross(x[0], e1), n), b0 = (dot(n, n) - b1) - b2;
    if (b0 > 0 && b1 > 0 && b2 > 0) return vertex_and(FeatureKind::vertex_face, 0, 0, 0);
    Candidate best;
    for (Index i = 0; i < 3; ++i) {
        const Index next = next_corner(i);
        const Point e = minus(x[next], x[i]);
        const double ee = dot(e, e), t = ee > 0 ? clamp(-dot(x[i], e) / ee) : 0;
        Point z;
        for (Index k = 0; k < 3; ++k) z[k] = x[i][k] + t * e[k];
        const double square = dot(z, z);
        if (!(square < best.square)) continue;
        const bool is_inside = t > 0 && t < 1;
        const FeatureKind kind = is_inside ? FeatureKind::vertex_edge : FeatureKind::vertex_vertex;
        best = {square, vertex_and(kind, 0, 0, t >= 1 ? next : i)};
    }
    return best.features;
}

}  // namespace

FeaturePair guess_features(const IntegerPair& pair) noexcept {
    if (pair.first_is_point) return guess_of_point(&to_doubles(pair)[3]);
    return FeatureGuess(to_doubles(pair)).find();
}

}  // namespace ecods::exact
