// Derivation. Letters, ScaledVectors, E and the bounds of polynomials are those of enclose_distance.cpp; the motion m
// is one more vector, each coordinate off by less than one of its units.
//
// Below. For ANY vector n, of doubles taken as they are, every point of the second triangle less every point of the
// first has at least the product G = n.w + min(0, n.b1, n.b2) - max(0, n.a1, n.a2) with n. Where they share a point at
// time s, one of these differences is s m. So
//     s n.m >= G:    with G > 0, s >= G / n.m,  and s > 0 is none if n.m <= 0.
// No error of n matters. G is bounded as there, by r3 - 4 u' r1; n.m, in units of m, by the product as computed and E,
// since m has an eta of 1. The quotient has three more roundings.
//
// Above. Where the signs that say so are certain, the features share a point at the time n.w / n.m, and n.w and n.m are
// known to E. Signs, in one power of two, for det(x, y, m) = (x x y).m and f, g the powers of two between the unit of w
// and those of u, v: a vertex with -w or w as `foot` and a face from q, p + s m = q + s1 u + s2 v,
//     s1 = det(foot, v, m) / (f det(u, v, m)),  s2 = det(u, foot, m) / (g det(u, v, m)),  1 - s1 - s2;
// edges, p + s1 u + s m = q + s2 v,
//     s1 = det(w, v, m) / (f det(u, v, m)),     s2 = det(w, u, m) / (g det(u, v, m)).
// These have the bound 6 (3 C + 5), sums of them as there. If n.m > 0 and the other corners are strictly on their sides
// of the planes of the features at right angles to n, no other point is shared then, and none before.
#include "exact/measure/enclose_contact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/number/dyadic.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

using What = ContactGuess::What;

ECODS_ALWAYS_INLINE double dot(const Point& a, const Point& b) noexcept {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
ECODS_ALWAYS_INLINE Point cross(const Point& a, const Point& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
ECODS_ALWAYS_INLINE Point negated(const Point& a) noexcept {
    return {-a[0], -a[1], -a[2]};
}

constexpr double size = 0x1p53;
constexpr double slack = 1 + 0x1p-20;

class Contact {
  public:
    Contact(const IntegerPair& pair, const ScaledVector& m, std::size_t p, std::size_t q) noexcept : m_(m) {
        const auto at = [&](std::size_t side, std::size_t i) -> const FixedPoints::Point& {
            return pair.at[3 * side + i % 3];
        };
        const bool is_exact = pair.error == 0;
        w_ = scaled(difference(at(1, q), at(0, p)), is_exact);
        for (std::size_t k = 0; k < 2; ++k) {
            other_[0][k] = scaled(difference(at(0, p + k + 1), at(0, p)), is_exact);
            other_[1][k] = scaled(difference(at(1, q + k + 1), at(1, q)), is_exact);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t k = 0; k < 2; ++k) factor_[side][k] = power_of_two(other_[side][k].shift - w_.shift);
        }
        eta_ = 1 + pair.error;
        bound_ = 6 * (1.5 * eta_ + 5) * two_u * (size * size * size) * slack;
        exponent_ = w_.shift + pair.unit - m.shift;
    }

    // The corner p or q of `side`, and the face of the other.
    void at_vertex_and_face(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point &u = other_[of][0].x, &v = other_[of][1].x;
        n_ = cross(u, v);
        const double det = dot(n_, m_.x);
        const double sign = det < 0 ? -1 : 1;
        const Point foot = of == 1 ? negated(w_.x) : w_.x;
        const double s = sign * dot(cross(foot, v), m_.x), t = sign * dot(cross(u, foot), m_.x);
        const double f = factor_[of][0], g = factor_[of][1];
        is_inside_ =
            (s > bound_) && (t > bound_) && ((std::abs(det) - s / f) - t / g > bound_ * (1 + 1 / f + 1 / g) * 2);
        if (det < 0) n_ = negated(n_);
        is_outside_ = is_outward(side, 0) && is_outward(side, 1);
    }

    void at_edges() noexcept {
        const Point &u = other_[0][0].x, &v = other_[1][0].x;
        n_ = cross(u, v);
        const double det = dot(n_, m_.x);
        const double sign = det < 0 ? -1 : 1;
        const double s = sign * dot(cross(w_.x, v), m_.x), t = sign * dot(cross(w_.x, u), m_.x);
        const double f = factor_[0][0], g = factor_[1][0], d = std::abs(det);
        is_inside_ =
            (s > bound_) && (t > bound_) && (d * f - s > bound_ * (1 + f) * 2) && (d * g - t > bound_ * (1 + g) * 2);
        if (det < 0) n_ = negated(n_);
        is_outside_ = is_outward(0, 1) && is_outward(1, 1);
    }

    // The plane of an edge and the motion, which is at right angles to n but for rounding.
    void at_edge(std::size_t side) noexcept {
        n_ = cross(m_.x, other_[side][0].x);
        if (dot(n_, w_.x) < 0) n_ = negated(n_);
    }

    void turn() noexcept { n_ = negated(n_); }

    ContactEnclosure result() const noexcept;

  private:
    bool is_outward(std::size_t side, std::size_t k) const noexcept {
        const double x = dot(n_, other_[side][k].x);
        return side == 0 ? x < -bound_ : x > bound_;
    }

    ScaledVector w_, m_;
    ScaledVector other_[2][2];
    double factor_[2][2];  // powers of two: from the unit of a vector to that of w_
    Point n_{0, 0, 0};     // towards the second triangle; along the motion, where it is a meeting
    double eta_, bound_;
    int exponent_;  // of times in units of w_ over units of m_
    bool is_inside_ = false, is_outside_ = false;
};

ECODS_ALWAYS_INLINE ContactEnclosure Contact::result() const noexcept {
    ContactEnclosure result;
    const double error = (8.5 + eta_) * ((std::abs(n_[0]) + std::abs(n_[1])) + std::abs(n_[2]));
    const double height = dot(n_, w_.x), first = height - error;
    double low = 0, high = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        low = std::min(low, (dot(n_, other_[1][k].x) - error) * factor_[1][k]);
        high = std::max(high, (dot(n_, other_[0][k].x) + error) * factor_[0][k]);
    }
    const double gap = ((first + low) - high) - 4 * two_u * first;
    if (!(gap > 0)) return result;
    const double speed = dot(n_, m_.x);
    if (!(speed + error > 0)) {
        result.lower = std::numeric_limits<double>::infinity();
        return result;
    }
    result.lower = scaled_down(gap / (speed + error) * (1 - 8 * two_u), exponent_);
    if (is_inside_ && speed > error) {
        result.upper = scaled_up((height + error) / (speed - error) * (1 + 8 * two_u), exponent_);
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
