// Derivation. Letters, ScaledVectors, E and the bounds of polynomials are those of triangle_vectors.hpp, for corners p
// and q that are both on the guessed features.
//
// Below: the gap along a vector n over its length, which is at most sqrt(n.n) (1 + 4 u'): three factors on the way of
// any term, all terms positive, and that of the root.
//
// Above: two feasible points. Weights c >= 0 of a1 and a2, of sum at most 1, and of b1 and b2, make points of the
// triangles, whose difference is z = w + cb1 b1 + cb2 b2 - ca1 a1 - ca2 a2. In powers of two of w weights are
// c 2^(shift - shift of w). A term meets one rounding as a product and four in sums at most, so a coordinate of z is
// off by at most ((1 + u')^5 - 1) X + eta <= 10.01 + eta times 1 + (the sum of these weights), and |z| by sqrt(3) of
// that. Weights that are not the best ones cost width only.
//
// Certain signs have the bounds, in units of u' times the product of the X,
//     x.y                                  3 (2 C + 3)
//     (x x y).z                            6 (3 C + 5)
//     (x x y).(z x v)                     12 (4 C + 7)
//     ((y.y) x - (x.y) y).z               18 (4 C + 8)
#include "exact/measure/distance/enclose_distance.hpp"

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/triangle_vectors.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

constexpr double root_of_3 = 1.7320509;

// The vectors between the corners of two triangles, and what the two ends of the interval are made of.
class Features {
  public:
    Features(const IntegerPair& pair, std::size_t p, std::size_t q) noexcept : x_(pair, p, q), c_(0.5 * x_.eta) {}

    void at_vertices() noexcept {
        n_ = x_.w.x;
        const double bound = 3 * (2 * c_ + 3) * two_u * square_of_size * second_order;
        is_certain_ =
            is_outward(0, 0, bound) && is_outward(0, 1, bound) && is_outward(1, 0, bound) && is_outward(1, 1, bound);
    }

    // The corner p or q of `side`, and the edge from the other's corner to the next one.
    void at_vertex_and_edge(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point& u = x_.other[of][0].x;
        const double uu = dot(u, u);
        if (!(uu > 0)) return;
        // For the point t u of the edge, counted as w is; `along` is its product with u.
        const double along = of == 1 ? -dot(x_.w.x, u) : dot(x_.w.x, u);
        const double f = x_.factor[of][0];
        const double t = std::min(std::max(along / uu, 0.0), f);
        weight_[of][0] = t;
        for (std::size_t k = 0; k < 3; ++k) n_[k] = x_.w.x[k] * uu + u[k] * (of == 1 ? along : -along);
        const double inside = 3 * (2 * c_ + 3) * two_u * square_of_size * second_order;
        const double outward = 18 * (4 * c_ + 8) * two_u * (square_of_size * square_of_size) * second_order;
        is_certain_ = (along > inside) && (uu * f - along > inside * (1 + f) * 2) && is_outward(side, 0, outward) &&
                      is_outward(side, 1, outward) && is_outward(of, 1, outward);
        // Once more perpendicular to the edge: near contact what is left of w is mostly error.
        const double rest = dot(n_, u) / uu;
        for (std::size_t k = 0; k < 3; ++k) n_[k] -= rest * u[k];
    }

    void at_edges() noexcept {
        const Point &u = x_.other[0][0].x, &v = x_.other[1][0].x;
        n_ = cross(u, v);
        const double nn = dot(n_, n_);
        if (!(nn > 0)) return;
        const double s = dot(cross(x_.w.x, v), n_), t = dot(cross(x_.w.x, u), n_);
        const double f = x_.factor[0][0], g = x_.factor[1][0];
        weight_[0][0] = std::min(std::max(s / nn, 0.0), f);
        weight_[1][0] = std::min(std::max(t / nn, 0.0), g);
        turn_towards_w();
        const double inside = inside_bound(), outward = 6 * (3 * c_ + 5) * two_u * cube_of_size * second_order;
        is_certain_ = (s > inside) && (t > inside) && (nn * f - s > inside * (1 + f) * 2) &&
                      (nn * g - t > inside * (1 + g) * 2) && (dot(n_, x_.w.x) > outward) && is_outward(0, 1, outward) &&
                      is_outward(1, 1, outward);
    }

    // The corner p or q of `side`, and the face of the other.
    void at_vertex_and_face(std::size_t side) noexcept {
        const std::size_t of = 1 - side;
        const Point &u = x_.other[of][0].x, &v = x_.other[of][1].x;
        n_ = cross(u, v);
        const double nn = dot(n_, n_);
        if (!(nn > 0)) return;
        const Point foot = of == 1 ? negated(x_.w.x) : x_.w.x;
        const double s = dot(cross(foot, v), n_), t = dot(cross(u, foot), n_);
        const double f = x_.factor[of][0], g = x_.factor[of][1];
        const double x = std::min(std::max(s / nn, 0.0), f);
        weight_[of][0] = x;
        // Weights of a sum of at most 1: the factor covers two roundings.
        weight_[of][1] = std::min(std::max(t / nn, 0.0), (1 - x / f) * (1 - 4 * two_u) * g);
        turn_towards_w();
        const double inside = inside_bound(), outward = 6 * (3 * c_ + 5) * two_u * cube_of_size * second_order;
        is_certain_ = (s > inside) && (t > inside) && ((nn - s / f) - t / g > inside * (1 + 1 / f + 1 / g) * 2) &&
                      (dot(n_, x_.w.x) > outward) && is_outward(side, 0, outward) && is_outward(side, 1, outward);
    }

    Enclosure result(int unit) const noexcept;

  private:
    double inside_bound() const noexcept {
        return 12 * (4 * c_ + 7) * two_u * (square_of_size * square_of_size) * second_order;
    }
    bool is_outward(std::size_t side, std::size_t k, double bound) const noexcept {
        return x_.is_outward(n_, side, k, bound);
    }
    void turn_towards_w() noexcept {
        if (dot(n_, x_.w.x) < 0) n_ = negated(n_);
    }
    double lower() const noexcept;
    double upper() const noexcept;

    TriangleVectors x_;
    double weight_[2][2] = {{0, 0}, {0, 0}};
    Point n_{0, 0, 0};
    double c_;
    bool is_certain_ = false;
};

ECODS_ALWAYS_INLINE double Features::lower() const noexcept {
    const double all = x_.gap(n_, x_.product_error(n_));
    const double length = std::sqrt(dot(n_, n_)) * (1 + 8 * two_u);
    return all > 0 ? all / length * (1 - 8 * two_u) : 0;
}

ECODS_ALWAYS_INLINE double Features::upper() const noexcept {
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

ECODS_ALWAYS_INLINE Enclosure Features::result(int unit) const noexcept {
    const int e = x_.w.shift + unit;
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
