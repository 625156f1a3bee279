// The distance of two triangles: all pairs of their features.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "oracle/distance.hpp"
#include "oracle/features.hpp"

namespace ecods::oracle {

// A feature of a and one of b: `dimension` 0 to 2, index of corner, edge or (0) face.
struct FeaturePair {
    Closeness kind;
    int dimension_a;
    std::uint32_t a;
    int dimension_b;
    std::uint32_t b;
};

// In the order of the rule: by kind, by the index of a, by the index of b, by the dimension of a.
std::span<const FeaturePair> feature_pairs();

template <class N>
FeatureDistance<N> feature_distance(const FeaturePair& pair, const TriangleOf<N>& a, const TriangleOf<N>& b) {
    switch (pair.kind) {
        case Closeness::vertex_vertex:
            return vertex_vertex(a.corner[pair.a], b.corner[pair.b]);
        case Closeness::vertex_edge:
            return pair.dimension_a == 0 ? vertex_edge(a.corner[pair.a], b, pair.b)
                                         : vertex_edge(b.corner[pair.b], a, pair.a);
        case Closeness::vertex_face:
            return pair.dimension_a == 0 ? vertex_face(a.corner[pair.a], b) : vertex_face(b.corner[pair.b], a);
        default:
            return edge_edge(a, pair.a, b, pair.b);
    }
}

// Bounds of the squared distance, and which features may hold the closest points.
struct Enclosure {
    double lower = std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    std::array<double, 42> feature_lower;  // infinity where the features surely do not count
    bool may_pierce = false;
};

Enclosure enclose(const TriangleOf<Interval>& a, const TriangleOf<Interval>& b);

// The least pairs of features, in integers; of them those that intervals leave. `num` is zero if the triangles share a
// point.
struct LeastFeatures {
    mpz_class num = -1;  // none yet
    mpz_class den = 1;
    bool is_zero() const { return sgn(num) == 0; }
    std::vector<std::size_t> pairs;  // all that attain it, ascending; of triangles that share a point, some or none
};

LeastFeatures least_features(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b,
                             const Enclosure& enclosure);

// The closest points of a pair of features that is inside, as integers over a common denominator.
struct IntegerPoint {
    Vector<mpz_class> num;
    mpz_class den = 1;

    // By coordinates.
    static int compare(const IntegerPoint& p, const IntegerPoint& q);
};

std::array<IntegerPoint, 2> closest_points(const FeaturePair& pair, const TriangleOf<mpz_class>& a,
                                           const TriangleOf<mpz_class>& b);

// The corners of what two triangles share, ascending; empty if they share nothing.
std::vector<IntegerPoint> shared_corners(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b);

}  // namespace ecods::oracle
