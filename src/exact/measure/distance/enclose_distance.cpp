// Both bounds of the distance are derived with w, a1, a2, b1, b2, E and the bounds of polynomials of
// triangle_vectors.hpp, where p and q are corners of the guessed features.
//
// The lower bound is the gap along a vector n, divided by the length of n. The length is at most sqrt(n.n) (1 + 4 u'):
// each term of n.n has at most three factors 1 + e, all terms are positive, and the root has one more.
//
// The upper bound is the distance of two points of the triangles. Weights c >= 0 of a1 and a2, of sum at most 1, and of
// b1 and b2, give points of the triangles, whose difference is z = w + cb1 b1 + cb2 b2 - ca1 a1 - ca2 a2. In w's power
// of two the weights are c 2^(shift - shift of w). A term has one rounding as a product and at most four in sums, so a
// coordinate of z is off by at most ((1 + u')^5 - 1) X + eta <= 10.01 + eta, times 1 plus the sum of these weights, and
// |z| by sqrt(3) times as much. Weights that are not optimal only make the interval wider.
// Claim: verify/proofs/enclosure.g
// Claim: verify/proofs/distance_ends.py
#include "exact/measure/distance/enclose_distance.hpp"

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/distance/triangle_vectors.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

constexpr double root_of_3 = 1.7320509;

// DistanceEnds computes both bounds of the distance for one pair of features, from the vector between the features and
// the vectors along the features.
class DistanceEnds {
  public:
    DistanceEnds(const IntegerPair& pair, const FeaturePair& f) noexcept : x_(pair, f) {
        if (f.kind == FeatureKind::vertex_vertex) {
            at_vertices();
        } else if (f.kind == FeatureKind::vertex_edge) {
            at_vertex_and_edge(f.vertex_side);
        } else {
            at_plane(f);
        }
    }

    Enclosure result(int unit) const noexcept;

  private:
    void at_vertices() noexcept {
        n_ = x_.w.x;
        const double bound = x_.bound_of_two();
        is_certain_ = x_.is_outward(n_, 0, 0, bound) && x_.is_outward(n_, 0, 1, bound) &&
                      x_.is_outward(n_, 1, 0, bound) && x_.is_outward(n_, 1, 1, bound);
    }

    // Sets weight_, n_ and is_certain_ for the first vertex (p or q) of triangle `side`, and the edge of the other
    // triangle that begins at its first corner.
    void at_vertex_and_edge(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point& u = x_.other[of][0].x;
        const double uu = dot(u, u);
        if (!(uu > 0)) return;
        // The foot of the vertex on the edge is t u, in w's power of two; `along` is t uu.
        const double along = of == 1 ? -dot(x_.w.x, u) : dot(x_.w.x, u);
        const double f = x_.factor[of][0];
        const double t = std::min(std::max(along / uu, 0.0), f);
        weight_[of][0] = t;
        for (std::size_t k = 0; k < 3; ++k) n_[k] = x_.w.x[k] * uu + u[k] * (of == 1 ? along : -along);
        const double inside = x_.bound_of_two(), outward = x_.bound_across();
        is_certain_ = (along > inside) && (uu * f - along > inside * (1 + f) * 2) &&
                      x_.is_outward(n_, side, 0, outward) && x_.is_outward(n_, side, 1, outward) &&
                      x_.is_outward(n_, of, 1, outward);
        // Makes n perpendicular to the edge once more, because near contact most of n along the edge is rounding error.
        const double rest = dot(n_, u) / uu;
        for (std::size_t k = 0; k < 3; ++k) n_[k] -= rest * u[k];
    }

    // Sets weight_, n_ and is_certain_ for a vertex and a face, or for two edges.
    void at_plane(const FeaturePair& pair) noexcept {
        n_ = x_.normal(pair);
        const TriangleVectors::Feet feet = x_.feet(pair, n_, n_, x_.bound_of_four());
        if (!(feet.den > 0)) return;
        if (pair.kind == FeatureKind::edge_edge) {
            weight_[0][0] = std::min(std::max(feet.s / feet.den, 0.0), x_.factor[0][0]);
            weight_[1][0] = std::min(std::max(feet.t / feet.den, 0.0), x_.factor[1][0]);
        } else {
            const std::size_t of = 1 - pair.vertex_side;
            const double f = x_.factor[of][0], g = x_.factor[of][1];
            const double x = std::min(std::max(feet.s / feet.den, 0.0), f);
            weight_[of][0] = x;
            // Limits the second weight such that the sum of both weights is at most 1; 1 - 4 u' covers two roundings.
            weight_[of][1] = std::min(std::max(feet.t / feet.den, 0.0), (1 - x / f) * (1 - 4 * two_u) * g);
        }
        if (dot(n_, x_.w.x) < 0) n_ = negated(n_);
        const double outward = x_.bound_of_three();
        is_certain_ = feet.are_inside && (dot(n_, x_.w.x) > outward) && x_.are_others_outward(pair, n_, outward);
    }

    double lower() const noexcept;
    double upper() const noexcept;

    TriangleVectors x_;
    double weight_[2][2] = {{0, 0}, {0, 0}};
    Point n_{0, 0, 0};
    bool is_certain_ = false;
};

ECODS_ALWAYS_INLINE double DistanceEnds::lower() const noexcept {
    const double all = x_.gap(n_, x_.product_error(n_));
    const double length = std::sqrt(dot(n_, n_)) * (1 + 8 * two_u);
    return all > 0 ? all / length * (1 - 8 * two_u) : 0;
}

ECODS_ALWAYS_INLINE double DistanceEnds::upper() const noexcept {
    Point z;
    for (std::size_t k = 0; k < 3; ++k) {
        z[k] = (((x_.w.x[k] + weight_[1][0] * x_.other[1][0].x[k]) + weight_[1][1] * x_.other[1][1].x[k]) -
                weight_[0][0] * x_.other[0][0].x[k]) -
               weight_[0][1] * x_.other[0][1].x[k];
    }
    const double weights = 1 + (weight_[0][0] + weight_[0][1]) + (weight_[1][0] + weight_[1][1]);
    const double error = root_of_3 * (10.25 + x_.eta) * weights;
    return (std::sqrt(dot(z, z)) * (1 + 8 * two_u) + error) * (1 + 8 * two_u);
}

ECODS_ALWAYS_INLINE Enclosure DistanceEnds::result(int unit) const noexcept {
    const int e = x_.w.shift + unit;
    const double low = lower();
    return {low > 0 ? scaled_down(low, e) : 0, scaled_up(upper(), e), is_certain_};
}

}  // namespace

Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept {
    return DistanceEnds(pair, features).result(pair.unit);
}

// The features are certain only if n . w is beyond its error; DistanceEnds computes the same number.
int certain_side_of_face(const IntegerPair& pair) noexcept {
    const FeaturePair features = vertex_and(FeatureKind::vertex_face, 0, 0, 0);
    const TriangleVectors x(pair, features);
    return dot(x.normal(features), x.w.x) > 0 ? -1 : 1;
}

}  // namespace ecods::exact
