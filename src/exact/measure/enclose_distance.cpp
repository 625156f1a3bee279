// Derivation. Let p be a corner of the first triangle and q one of the second, both on the guessed features, w = q - p,
// and a1, a2 and b1, b2 the other corners of either triangle less p and q. Every vector is a ScaledVector: below, it is
// counted in its own power of two. Coordinates are integers of magnitude at most X = 2^53, and off by at most
//     eta = 1 + error <= 6:
// one for the shift, `error` for the points, whose unit is at most the vector's. u' = 2^-52 bounds one operation.
//
// Below: weak duality. For ANY vector n, of doubles taken as they are, every point of the second triangle less every
// point of the first has at least the product min(0, n.b1, n.b2) + n.w - max(0, n.a1, n.a2) with n, so
//     distance >= (n.w + min(0, n.b1, n.b2) - max(0, n.a1, n.a2)) / |n|.
// No error of n matters. A product n.x as computed, three products and two sums, meets at most three factors (1 + e):
//     |fl(n.x) - n.x_true| <= ((1 + u')^3 - 1) X |n|_1 + eta |n|_1 <= (6.01 + eta) |n|_1,   u' X = 2.
// Subtracting a bound from it, or adding one, rounds by up to u' (X |n|_1 + the bound) < 2.01 |n|_1. |n|_1 as computed
// is low by (1 - u')^2 at most. So E = (8.5 + eta) times it, subtracted or added, leaves a bound of the true product.
// Let r1 = n.w - E, r2 = r1 + min, r3 = r2 - max as computed, brought to the power of two of w, which is exact. The
// last two round by u' of their results, and r3 <= r2 <= r1, so the sum is at least r3 - 4 u' r1. The length is at most
// sqrt(n.n) (1 + 4 u'): three factors on the way of any term, all terms positive, and that of the root.
//
// Above: two feasible points. Weights c >= 0 of a1 and a2, of sum at most 1, and of b1 and b2, make points of the
// triangles, whose difference is z = w + cb1 b1 + cb2 b2 - ca1 a1 - ca2 a2. In powers of two of w weights are
// c 2^(shift - shift of w). A term meets one rounding as a product and four in sums at most, so a coordinate of z is
// off by at most ((1 + u')^5 - 1) X + eta <= 10.01 + eta times 1 + (the sum of these weights), and |z| by sqrt(3) of
// that. Weights that are not the best ones cost width only.
//
// Certain signs. A vector is off by C u' X in each coordinate, C = eta / 2. A polynomial of m monomials of degree g in
// vectors, evaluated with at most r roundings on the way of any monomial, is off by at most m (g C + r) u' times the
// product of the X: a monomial meets at most (1 + C u')^g (1 + u')^r, and 2^-20 more covers the second order and the
// bound's own arithmetic. So
//     x.y                                  3 (2 C + 3)
//     (x x y).z                            6 (3 C + 5)
//     (x x y).(z x v)                     12 (4 C + 7)
//     ((y.y) x - (x.y) y).z               18 (4 C + 8)
// A difference of two such numbers in one power of two has the sum of the bounds, and twice that covers its rounding.
// All numbers are 0 or between 2^-200 and 2^600: nothing underflows or overflows.
#include "exact/measure/enclose_distance.hpp"

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/guess_features.hpp"
#include "exact/measure/scaled_vector.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

ECODS_ALWAYS_INLINE double dot(const Point& a, const Point& b) noexcept {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
ECODS_ALWAYS_INLINE Point cross(const Point& a, const Point& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
ECODS_ALWAYS_INLINE Point negated(const Point& a) noexcept {
    return {-a[0], -a[1], -a[2]};
}

inline constexpr double size = 0x1p53;
inline constexpr double slack = 1 + 0x1p-20;
inline constexpr double root_of_3 = 1.7320509;

// The vectors between the corners of two triangles, and what the two ends of the interval are made of.
class Features {
  public:
    Features(const IntegerPair& pair, std::size_t p, std::size_t q) noexcept {
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
            for (std::size_t k = 0; k < 2; ++k) {
                factor_[side][k] = power_of_two(other_[side][k].shift - w_.shift);
            }
        }
        eta_ = 1 + pair.error;
        c_ = 0.5 * eta_;
    }

    void at_vertices() noexcept {
        n_ = w_.x;
        const double bound = 3 * (2 * c_ + 3) * two_u * (size * size) * slack;
        is_certain_ =
            is_outward(0, 0, bound) && is_outward(0, 1, bound) && is_outward(1, 0, bound) && is_outward(1, 1, bound);
    }

    // The corner p or q of `side`, and the edge from the other's corner to the next one.
    void at_vertex_and_edge(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point& u = other_[of][0].x;
        const double uu = dot(u, u);
        if (!(uu > 0)) return;
        // For the point t u of the edge, counted as w is; `along` is its product with u.
        const double along = of == 1 ? -dot(w_.x, u) : dot(w_.x, u);
        const double f = factor_[of][0];
        const double t = std::min(std::max(along / uu, 0.0), f);
        weight_[of][0] = t;
        for (std::size_t k = 0; k < 3; ++k) n_[k] = w_.x[k] * uu + u[k] * (of == 1 ? along : -along);
        const double inside = 3 * (2 * c_ + 3) * two_u * (size * size) * slack;
        const double outward = 18 * (4 * c_ + 8) * two_u * (size * size) * (size * size) * slack;
        is_certain_ = (along > inside) && (uu * f - along > inside * (1 + f) * 2) && is_outward(side, 0, outward) &&
                      is_outward(side, 1, outward) && is_outward(of, 1, outward);
        // Once more perpendicular to the edge: near contact what is left of w is mostly error.
        const double rest = dot(n_, u) / uu;
        for (std::size_t k = 0; k < 3; ++k) n_[k] -= rest * u[k];
    }

    void at_edges() noexcept {
        const Point &u = other_[0][0].x, &v = other_[1][0].x;
        n_ = cross(u, v);
        const double nn = dot(n_, n_);
        if (!(nn > 0)) return;
        const double s = dot(cross(w_.x, v), n_), t = dot(cross(w_.x, u), n_);
        const double f = factor_[0][0], g = factor_[1][0];
        weight_[0][0] = std::min(std::max(s / nn, 0.0), f);
        weight_[1][0] = std::min(std::max(t / nn, 0.0), g);
        turn_towards_w();
        const double inside = inside_bound(), outward = 6 * (3 * c_ + 5) * two_u * (size * size * size) * slack;
        is_certain_ = (s > inside) && (t > inside) && (nn * f - s > inside * (1 + f) * 2) &&
                      (nn * g - t > inside * (1 + g) * 2) && (dot(n_, w_.x) > outward) && is_outward(0, 1, outward) &&
                      is_outward(1, 1, outward);
    }

    // The corner p or q of `side`, and the face of the other.
    void at_vertex_and_face(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point &u = other_[of][0].x, &v = other_[of][1].x;
        n_ = cross(u, v);
        const double nn = dot(n_, n_);
        if (!(nn > 0)) return;
        const Point foot = of == 1 ? negated(w_.x) : w_.x;
        const double s = dot(cross(foot, v), n_), t = dot(cross(u, foot), n_);
        const double f = factor_[of][0], g = factor_[of][1];
        const double x = std::min(std::max(s / nn, 0.0), f);
        weight_[of][0] = x;
        // Weights of a sum of at most 1: the factor covers two roundings.
        weight_[of][1] = std::min(std::max(t / nn, 0.0), (1 - x / f) * (1 - 4 * two_u) * g);
        turn_towards_w();
        const double inside = inside_bound(), outward = 6 * (3 * c_ + 5) * two_u * (size * size * size) * slack;
        is_certain_ = (s > inside) && (t > inside) && ((nn - s / f) - t / g > inside * (1 + 1 / f + 1 / g) * 2) &&
                      (dot(n_, w_.x) > outward) && is_outward(side, 0, outward) && is_outward(side, 1, outward);
    }

    Enclosure result(int unit) const noexcept;

  private:
    double inside_bound() const noexcept { return 12 * (4 * c_ + 7) * two_u * (size * size) * (size * size) * slack; }
    bool is_outward(std::size_t side, std::size_t k, double bound) const noexcept {
        const double x = dot(n_, other_[side][k].x);
        return side == 0 ? x < -bound : x > bound;
    }
    void turn_towards_w() noexcept {
        if (dot(n_, w_.x) < 0) n_ = negated(n_);
    }
    double lower() const noexcept;
    double upper() const noexcept;

    ScaledVector w_;
    ScaledVector other_[2][2];
    double factor_[2][2];  // powers of two: from the unit of a vector to that of w_
    double weight_[2][2] = {{0, 0}, {0, 0}};
    Point n_{0, 0, 0};
    double eta_, c_;
    bool is_certain_ = false;
};

ECODS_ALWAYS_INLINE double Features::lower() const noexcept {
    const double error = (8.5 + eta_) * ((std::abs(n_[0]) + std::abs(n_[1])) + std::abs(n_[2]));
    const double first = dot(n_, w_.x) - error;
    double low = 0, high = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        low = std::min(low, (dot(n_, other_[1][k].x) - error) * factor_[1][k]);
        high = std::max(high, (dot(n_, other_[0][k].x) + error) * factor_[0][k]);
    }
    const double all = ((first + low) - high) - 4 * two_u * first;
    const double length = std::sqrt(dot(n_, n_)) * (1 + 8 * two_u);
    return all > 0 ? all / length * (1 - 8 * two_u) : 0;
}

ECODS_ALWAYS_INLINE double Features::upper() const noexcept {
    Point z;
    for (std::size_t k = 0; k < 3; ++k) {
        z[k] = (((w_.x[k] + weight_[1][0] * other_[1][0].x[k]) + weight_[1][1] * other_[1][1].x[k]) -
                weight_[0][0] * other_[0][0].x[k]) -
               weight_[0][1] * other_[0][1].x[k];
    }
    const double weights = 1 + (weight_[0][0] + weight_[0][1]) + (weight_[1][0] + weight_[1][1]);
    const double error = root_of_3 * (10.25 + eta_) * weights;
    return (std::sqrt(dot(z, z)) * (1 + 8 * two_u) + error) * (1 + 8 * two_u);
}

ECODS_ALWAYS_INLINE Enclosure Features::result(int unit) const noexcept {
    const int e = w_.shift + unit;
    const double low = lower();
    return {low > 0 ? scaled_down(low, e) : 0, scaled_up(upper(), e), is_certain_};
}

}  // namespace

std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept {
    std::array<IntegerVector, 3> edges;
    Uint128 digits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        edges[i] = difference(pair.at[3 * side + (i + 2) % 3], pair.at[3 * side + (i + 1) % 3]);
        digits |= digits_of(edges[i]);
    }
    const int shift = shift_of(digits);
    std::array<double, 3> squares;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point x = shifted(edges[i], shift);
        squares[i] = dot(x, x);
    }
    return squares[0] >= squares[1] ? (squares[0] >= squares[2] ? 0 : 2) : squares[1] >= squares[2] ? 1 : 2;
}

Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept {
    const std::size_t side = features.vertex_side;
    std::size_t p = features.a, q = features.b;
    if (features.kind == FeatureKind::vertex_face) (side == 0 ? q : p) = blunt_corner(pair, 1 - side);
    Features found(pair, p, q);
    switch (features.kind) {
        case FeatureKind::vertex_vertex:
            found.at_vertices();
            break;
        case FeatureKind::vertex_edge:
            found.at_vertex_and_edge(side);
            break;
        case FeatureKind::vertex_face:
            found.at_vertex_and_face(side);
            break;
        case FeatureKind::edge_edge:
            found.at_edges();
            break;
    }
    return found.result(pair.unit);
}

Points<6> to_doubles(const IntegerPair& pair) noexcept {
    std::array<IntegerVector, 6> vectors;
    Uint128 digits = 0;
    vectors[0] = {0, 0, 0};
    for (std::size_t i = 1; i < 6; ++i) {
        vectors[i] = difference(pair.at[i], pair.at[0]);
        digits |= digits_of(vectors[i]);
    }
    const int shift = shift_of(digits);
    Points<6> points;
    for (std::size_t i = 0; i < 6; ++i) points[i] = shifted(vectors[i], shift);
    return points;
}

FeaturePair guess_features(const IntegerPair& pair) noexcept {
    return guess_features(to_doubles(pair));
}

}  // namespace ecods::exact
