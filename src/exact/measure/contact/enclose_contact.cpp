// Derivation. Letters, ScaledVectors, E and the bounds of polynomials are those of triangle_vectors.hpp; the motion m
// is one more vector, each coordinate off by less than one of its units.
//
// Below. For ANY vector n, of doubles taken as they are, every point of the second triangle less every point of the
// first has at least the product G = n.w + min(0, n.b1, n.b2) - max(0, n.a1, n.a2) with n. Where they share a point at
// time s, one of these differences is s m. So
//     s n.m >= G:    with G > 0, s >= G / n.m,  and s > 0 is none if n.m <= 0.
// No error of n matters. G is bounded as there, by r3 - 4 u' r1; n.m, in units of m, by the product as computed and E,
// since m has an eta of 1. The quotient has three more roundings.
//
// Above. Where the signs that say so are certain, the features share a point at the time n.w / n.m for the true n,
// which the one as computed is not: of a sliver it is off by more than it is long. So the determinants det(u, v, w) and
// det(u, v, m) are known to the bound of signs, not to E. Signs, in one power of two, for det(x, y, m) = (x x y).m and
// f, g the powers of two between the unit of w and those of u, v: a vertex with -w or w as `foot` and a face from q, p
// + s m = q + s1 u + s2 v,
//     s1 = det(foot, v, m) / (f det(u, v, m)),  s2 = det(u, foot, m) / (g det(u, v, m)),  1 - s1 - s2;
// edges, p + s1 u + s m = q + s2 v,
//     s1 = det(w, v, m) / (f det(u, v, m)),     s2 = det(w, u, m) / (g det(u, v, m)).
// These have the bound 6 (3 C + 5), sums of them as there. If n.m > 0 and the other corners are strictly on their sides
// of the planes of the features at right angles to n, no other point is shared then, and none before.
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

using What = ContactGuess::What;

class Contact {
  public:
    Contact(const IntegerPair& pair, const ScaledVector& m, std::size_t p, std::size_t q) noexcept
        : x_(pair, p, q),
          m_(m),
          bound_(6 * (1.5 * x_.eta + 5) * two_u * cube_of_size * second_order),
          exponent_(x_.w.shift + pair.unit - m.shift) {}

    // The corner p or q of `side`, and the face of the other.
    void at_vertex_and_face(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point &u = x_.other[of][0].x, &v = x_.other[of][1].x;
        n_ = cross(u, v);
        const double det = dot(n_, m_.x);
        const double sign = det < 0 ? -1 : 1;
        const Point foot = of == 1 ? negated(x_.w.x) : x_.w.x;
        const double s = sign * dot(cross(foot, v), m_.x), t = sign * dot(cross(u, foot), m_.x);
        const double f = x_.factor[of][0], g = x_.factor[of][1];
        is_inside_ =
            (s > bound_) && (t > bound_) && ((std::abs(det) - s / f) - t / g > bound_ * (1 + 1 / f + 1 / g) * 2);
        if (det < 0) n_ = negated(n_);
        is_outside_ = is_outward(side, 0) && is_outward(side, 1);
    }

    void at_edges() noexcept {
        const Point &u = x_.other[0][0].x, &v = x_.other[1][0].x;
        n_ = cross(u, v);
        const double det = dot(n_, m_.x);
        const double sign = det < 0 ? -1 : 1;
        const double s = sign * dot(cross(x_.w.x, v), m_.x), t = sign * dot(cross(x_.w.x, u), m_.x);
        const double f = x_.factor[0][0], g = x_.factor[1][0], d = std::abs(det);
        is_inside_ =
            (s > bound_) && (t > bound_) && (d * f - s > bound_ * (1 + f) * 2) && (d * g - t > bound_ * (1 + g) * 2);
        if (det < 0) n_ = negated(n_);
        is_outside_ = is_outward(0, 1) && is_outward(1, 1);
    }

    // The plane of an edge and the motion, which is at right angles to n but for rounding.
    void at_edge(std::size_t side) noexcept {
        n_ = cross(m_.x, x_.other[side][0].x);
        if (dot(n_, x_.w.x) < 0) n_ = negated(n_);
    }

    void turn() noexcept { n_ = negated(n_); }

    ContactEnclosure result() const noexcept;

  private:
    bool is_outward(std::size_t side, std::size_t k) const noexcept { return x_.is_outward(n_, side, k, bound_); }

    TriangleVectors x_;
    ScaledVector m_;
    Point n_{0, 0, 0};  // towards the second triangle; along the motion, where it is a meeting
    double bound_;
    int exponent_;  // of times in units of w over units of m_
    bool is_inside_ = false, is_outside_ = false;
};

ECODS_ALWAYS_INLINE ContactEnclosure Contact::result() const noexcept {
    ContactEnclosure result;
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

ContactEnclosure enclose_contact(const IntegerPair& pair, const ScaledVector& m, const ContactGuess& guess) noexcept {
    const FeaturePair& f = guess.features;
    std::size_t p = f.a, q = f.b;
    if (f.kind == FeatureKind::vertex_vertex) return {};
    if (f.kind == FeatureKind::vertex_face) (f.vertex_side == 0 ? q : p) = blunt_corner(pair, 1 - f.vertex_side);
    Contact contact(pair, m, p, q);
    switch (f.kind) {
        case FeatureKind::vertex_face:
            contact.at_vertex_and_face(f.vertex_side);
            break;
        case FeatureKind::edge_edge:
            contact.at_edges();
            break;
        default:
            contact.at_edge(f.vertex_side);
    }
    if (guess.what == What::leaving) contact.turn();
    return contact.result();
}

ContactGuess guess_contact(const IntegerPair& pair, const ScaledVector& m) noexcept {
    return guess_contact(to_doubles(pair), m.x);
}

}  // namespace ecods::exact
