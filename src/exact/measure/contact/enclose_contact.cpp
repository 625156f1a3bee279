// This derivation proves the bounds of enclose_contact(). w, a1, a2, b1, b2, ScaledVectors, E, and the bounds of
// polynomials are defined in triangle_vectors.hpp. The motion m is one more ScaledVector, each coordinate off by less
// than one of its units.
//
// Lower bound. Let n be ANY vector whose coordinates are doubles. For every point p of the first triangle and q of the
// second, n.(q - p) is at least G = n.w + min(0, n.b1, n.b2) - max(0, n.a1, n.a2). If the triangles share a point at
// time s, one of these differences q - p is s m. So
//     s n.m >= G:    if G > 0, s >= G / n.m, and if also n.m <= 0 there is no such s > 0.
// n is used as it was computed, so its errors do not matter. G is bounded as in triangle_vectors.hpp, by r3 - 4 u' r1.
// n.m, in units of m, is at most the computed product plus E, since m has an eta of 1. The quotient has three more
// roundings.
//
// Upper bound. If the signs of the feet are certain, the features share a point at the time n.w / n.m for the true n.
// The computed n is not the true one: for a sliver its error is larger than n. So the determinants det(u, v, w) and
// det(u, v, m), where det(x, y, m) = (x x y).m, have the error bound of signs, not E. The features share a point if
// their feet along m are inside: p + s m = q + s1 u + s2 v for a vertex p and a face from q, p + s1 u + s m = q + s2 v
// for edges. If n.m > 0 and the other corners are strictly on their own triangles' sides of the planes through the
// features perpendicular to n, the triangles share no other point at that time, and none before.
// Claim: verify/proofs/contact_ends.py
#include "exact/measure/contact/enclose_contact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/distance/triangle_vectors.hpp"
#include "exact/number/dyadic.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

class ContactEnds {
  public:
    ContactEnds(const IntegerPair& pair, const ScaledVector& m, const FeaturePair& f) noexcept
        : x_(pair, f), m_(m), bound_(x_.bound_of_three()), exponent_(x_.w.shift + pair.unit - m.shift) {
        if (f.kind == FeatureKind::vertex_edge) {
            // The vector n_ is the normal of the plane through the edge along the motion, so it is perpendicular to the
            // motion up to rounding.
            n_ = cross(m_.x, x_.other[f.vertex_side][0].x);
            if (dot(n_, x_.w.x) < 0) n_ = negated(n_);
        } else {
            at_plane(f);
        }
    }

    void turn() noexcept { n_ = negated(n_); }

    Enclosure result() const noexcept;

  private:
    // Sets n_, is_inside_ and is_outside_ for a vertex and a face, or for two edges.
    void at_plane(const FeaturePair& f) noexcept {
        n_ = x_.normal(f);
        is_inside_ = x_.feet(f, n_, m_.x, bound_).are_inside;
        if (dot(n_, m_.x) < 0) n_ = negated(n_);
        is_outside_ = x_.are_others_outward(f, n_, bound_);
    }

    TriangleVectors x_;
    ScaledVector m_;
    Point n_{0, 0, 0};  // points towards the second triangle; along the motion if the guess is a meeting
    double bound_;
    int exponent_;  // times in units of w over units of m_ are multiplied by 2^exponent_
    bool is_inside_ = false, is_outside_ = false;
};

ECODS_ALWAYS_INLINE Enclosure ContactEnds::result() const noexcept {
    Enclosure result;
    const double error = x_.product_error(n_), gap = x_.gap(n_, error);
    if (!(gap > 0)) return result;
    const double speed = dot(n_, m_.x);
    if (!(speed + error > 0)) {
        result.lower = std::numeric_limits<double>::infinity();
        return result;
    }
    result.lower = scaled_down(gap / (speed + error) * (1 - 8 * two_u), exponent_);
    if (is_inside_ && speed > bound_) {
        result.upper = scaled_up((dot(n_, x_.w.x) + bound_) / (speed - bound_) * (1 + 8 * two_u), exponent_);
        result.is_certain = is_outside_;
    }
    return result;
}

}  // namespace

ScaledVector scaled_motion(const Vec3& m) noexcept {
    std::array<Dyadic, 3> d;
    BitRange range;
    for (std::size_t k = 0; k < 3; ++k) {
        d[k] = decode(m[static_cast<Eigen::Index>(k)]);
        range.include(d[k]);
    }
    ScaledVector result{{0, 0, 0}, range.empty() ? 0 : range.high - mantissa_bits};
    for (std::size_t k = 0; k < 3; ++k) {
        const int up = d[k].e - result.shift;
        const std::int64_t x = d[k].m == 0 ? 0 : up >= 0 ? d[k].m << up : d[k].m >> std::min(-up, 63);
        result.x[k] = static_cast<double>(x);
    }
    return result;
}

Enclosure enclose_contact(const IntegerPair& pair, const ScaledVector& m, const ContactGuess& guess) noexcept {
    if (guess.features.kind == FeatureKind::vertex_vertex) return {};
    ContactEnds ends(pair, m, guess.features);
    if (guess.what == ContactGuess::What::leaving) ends.turn();
    return ends.result();
}

}  // namespace ecods::exact
