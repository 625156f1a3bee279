#include "exact/measure/contact/meeting_place.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/measure/round/long_rounding.hpp"
#include "exact/number/nearest_double.hpp"
#include "exact/number/root.hpp"

namespace ecods::exact {
namespace {

using Numerators = RelativePosition::Vector;

// A LongPolynomial is a polynomial of any degree; its first coefficient is the constant term.
using LongPolynomial = std::vector<Integer>;

LongPolynomial square(const Polynomial& p) {
    const int degree = p.degree();
    if (degree < 0) return {};
    LongPolynomial result(static_cast<std::size_t>(2 * degree + 1));
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; j <= degree; ++j) {
            Integer& c = result[static_cast<std::size_t>(i + j)];
            c = c + p[i] * p[j];
        }
    }
    return result;
}

// Adds k p to the polynomial `sum`.
void add(LongPolynomial& sum, const Integer& k, const LongPolynomial& p) {
    if (sum.size() < p.size()) sum.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) sum[i] = sum[i] + k * p[i];
}

Polynomial times(const Polynomial& p, const Integer& k) {
    return p * Polynomial(k, {});
}

Polynomial oriented(const Polynomial& p, int sign) {
    return sign < 0 ? Polynomial() - p : p;
}

// NumbersAtRoot computes numbers at a root of p, each rounded once.
class NumbersAtRoot {
  public:
    NumbersAtRoot(Root& root, const Polynomial& p, double time) : root_(root), p_(p), near_(binary_fraction(time)) {}

    int sign_of(const Polynomial& g) { return root_.sign_of(g); }
    // Returns the sign of p_ just before the root.
    int sign_before() {
        int alternating = -1;
        for (Polynomial d = derivative(p_);; d = derivative(d), alternating = -alternating) {
            if (const int sign = sign_of(d); sign != 0) return alternating * sign;
        }
    }
    // Returns num / den times 2^unit at the root, rounded once. den must not be zero there.
    double quotient(const Polynomial& num, const Polynomial& den, int unit) {
        const int sign_num = sign_of(num), sign_den = sign_of(den);
        if (sign_num == 0) return 0;
        const Polynomial n = oriented(num, sign_num), d = oriented(den, sign_den);
        const Integer d_near = value_near(d);
        const double guess =
            d_near.is_zero() ? 0
                             : std::abs(round_quotient(ScaledInteger(value_near(n), unit), ScaledInteger(d_near, 0)));
        const double size = nearest_double(guess, [&](const BinaryFraction& m) {
            const int shift = unit + m.bits;
            return sign_of(times(n, Integer(std::int64_t{1}) << (shift > 0 ? shift : 0)) -
                           times(d, m.m << (shift < 0 ? -shift : 0)));
        });
        return sign_num * sign_den < 0 ? opposite(size) : size;
    }
    // Returns the unit vector f / |f| at the root; each coordinate is rounded once.
    Vec3 direction(const Numerators& f) {
        LongPolynomial length;
        std::array<LongPolynomial, 3> squares;
        ScaledLongVector near;
        for (std::size_t k = 0; k < 3; ++k) {
            squares[k] = square(f[k]);
            add(length, Integer(std::int64_t{1}), squares[k]);
            near[k] = ScaledInteger(value_near(f[k]), 0);
        }
        const Vec3 guess = is_zero(near) ? Vec3(Vec3::Zero()) : round_direction(near);
        Vec3 result = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const int sign = sign_of(f[k]);
            if (sign == 0) continue;
            const auto axis = static_cast<Eigen::Index>(k);
            const double size = nearest_double(std::abs(guess[axis]), [&](const BinaryFraction& m) {
                LongPolynomial difference;
                add(difference, Integer(std::int64_t{1}) << (2 * m.bits), squares[k]);
                add(difference, -(m.m * m.m), length);
                return sign_of(std::move(difference));
            });
            result[axis] = sign < 0 ? opposite(size) : size;
        }
        return result;
    }

  private:
    // Returns the sign of g at the root, by the remainder of g divided by p, times powers of p's leading coefficient.
    int sign_of(LongPolynomial g) {
        const int degree = p_.degree();
        const Integer& leading = p_[degree];
        int sign = 1;
        while (static_cast<int>(g.size()) > degree) {
            const Integer last = std::move(g.back());
            g.pop_back();
            const std::size_t first = g.size() - static_cast<std::size_t>(degree);
            for (Integer& c : g) c = leading * c;
            for (int i = 0; i < degree; ++i) {
                Integer& c = g[first + static_cast<std::size_t>(i)];
                c = c - last * p_[i];
            }
            sign *= leading.sign();
        }
        Polynomial::Coefficients c;
        for (std::size_t i = 0; i < g.size(); ++i) c[i] = std::move(g[i]);
        return sign * sign_of(Polynomial(std::move(c)));
    }
    // Returns an approximate value at the root: that of p at the rounded time, times a power of two that is the same
    // for all polynomials.
    Integer value_near(const Polynomial& p) const {
        Integer value;
        for (int i = Polynomial::degree_max; i >= 0; --i) {
            value = value * near_.m + (p[i] << ((Polynomial::degree_max - i) * near_.bits));
        }
        return value;
    }

    Root& root_;
    const Polynomial& p_;
    BinaryFraction near_;
};

const Polynomial* first_not_zero(const Numerators& v) noexcept {
    for (const Polynomial& p : v) {
        if (!p.is_zero()) return &p;
    }
    return nullptr;
}

// Returns a polynomial that is zero at each time at which the features share a point: their volume for a vertex and a
// face or for two edges, otherwise a coordinate of their turn or difference that is not the zero polynomial. Returns
// the zero polynomial, which gives no information, if there is no other.
Polynomial vanishing(RelativePosition& triangles, const FeaturePair& f) {
    const std::size_t side = f.vertex_side;
    Numerators coordinates;
    switch (f.kind) {
        case FeatureKind::vertex_face:
            return triangles.corner_volume(side, f.corner(side));
        case FeatureKind::edge_edge:
            return triangles.edge_volume(f.a, f.b);
        case FeatureKind::vertex_edge:
            coordinates = triangles.turn({side, f.corner(side), f.corner(1 - side)});
            break;
        case FeatureKind::vertex_vertex:
            for (std::size_t axis = 0; axis < 3; ++axis) coordinates[axis] = triangles.difference(f.a, f.b, axis);
    }
    const Polynomial* const found = first_not_zero(coordinates);
    return found == nullptr ? Polynomial() : *found;
}

Numerators plus(const Numerators& a, const Numerators& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// Returns the cross product of the first triangle's edge and the second triangle's edge, as polynomials.
Numerators across(RelativePosition& triangles, const FeaturePair& f) {
    const Numerators first = triangles.turn({1, f.b, f.a}), second = triangles.turn({1, next_corner(f.b), f.a});
    return {second[0] - first[0], second[1] - first[1], second[2] - first[2]};
}

Vec3 point_at(RelativePosition& triangles, const SecondCorners& second, const FeaturePair& f, NumbersAtRoot& numbers) {
    const Polynomial one(Integer(std::int64_t{1}), {});
    const Numerators& y = second.at[f.has_vertex(1) ? f.b : f.kind == FeatureKind::edge_edge ? f.b : 0];
    Vec3 point;
    std::size_t axis = 0;
    Numerators turn, n;
    if (f.kind == FeatureKind::edge_edge) {
        turn = triangles.turn({1, f.b, f.a});
        n = across(triangles, f);
        while (axis < 2 && numbers.sign_of(n[axis]) == 0) ++axis;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        double& x = point[static_cast<Eigen::Index>(k)];
        if (f.has_vertex(1)) {
            x = numbers.quotient(y[k], one, second.unit);
        } else if (f.has_vertex(0)) {
            x = numbers.quotient(triangles.difference(f.a, 0, k) + second.factor * y[k], second.factor, second.unit);
        } else {
            const Polynomial edge = second.at[next_corner(f.b)][k] - y[k];
            x = numbers.quotient(y[k] * n[axis] - edge * turn[axis], n[axis], second.unit);
        }
    }
    return point;
}

// Returns the unit normal of a face or of two edges at the root, from the first to the second triangle.
Vec3 normal_at(RelativePosition& triangles, const FeaturePair& f, NumbersAtRoot& numbers) {
    int sign = numbers.sign_before();
    Numerators n;
    if (f.kind == FeatureKind::edge_edge) {
        n = across(triangles, f);
    } else {
        const std::size_t side = f.vertex_side, corner = f.corner(side);
        n = plus(plus(triangles.turn({side, corner, 0}), triangles.turn({side, corner, 1})),
                 triangles.turn({side, corner, 2}));
        if (side == 0) sign = -sign;  // the first triangle's corner is on that side of the second one's face
    }
    return numbers.direction({oriented(n[0], sign), oriented(n[1], sign), oriented(n[2], sign)});
}

}  // namespace

std::optional<MeetingPlace> find_meeting_place(RelativePosition& triangles, const SecondCorners& second,
                                               const FeaturePair& features, double time) {
    const Polynomial p = vanishing(triangles, features);
    for (Root& root : roots_in_unit_interval(p)) {
        if (key_of(root.round()) != key_of(time)) continue;
        if (!TrianglesAtRoot(triangles, root).share_point(features)) continue;
        NumbersAtRoot numbers(root, p, time);
        MeetingPlace place{point_at(triangles, second, features, numbers), {}};
        const bool has_normal = features.kind == FeatureKind::vertex_face || features.kind == FeatureKind::edge_edge;
        if (has_normal) place.normal = normal_at(triangles, features, numbers);
        return place;
    }
    return std::nullopt;
}

}  // namespace ecods::exact
