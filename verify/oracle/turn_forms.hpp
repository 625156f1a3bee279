// Bodies that turn on a piece of the time, as forms of how far the time is from both ends; turn_subdivision.hpp says
// which. A direction along which all differences of two triangles' corners have one sign proves that they are apart.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/triangle_distance.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle::turn_forms {

using Integers = Vector<mpz_class>;
using oracle::Corners;

// A sum of c_i u^i v^(n - i).
struct Form {
    std::vector<mpz_class> c;  // from v^n to u^n

    const mpz_class& at_low() const { return c.front(); }
    const mpz_class& at_high() const { return c.back(); }

    friend Form operator*(const Form& f, const Form& g) {
        Form product{std::vector<mpz_class>(f.c.size() + g.c.size() - 1)};
        for (std::size_t i = 0; i < f.c.size(); ++i) {
            for (std::size_t j = 0; j < g.c.size(); ++j) product.c[i + j] += f.c[i] * g.c[j];
        }
        return product;
    }
    friend Form operator*(const mpz_class& x, Form f) {
        for (mpz_class& c : f.c) c *= x;
        return f;
    }
    // Both have the same degree.
    friend Form operator+(Form f, const Form& g) {
        for (std::size_t i = 0; i < f.c.size(); ++i) f.c[i] += g.c[i];
        return f;
    }
    friend Form operator-(Form f, const Form& g) {
        for (std::size_t i = 0; i < f.c.size(); ++i) f.c[i] -= g.c[i];
        return f;
    }
};
using Forms = Vector<Form>;

// The sign of the form for all u, v >= 0 that are not both 0; 0 if the coefficients do not show it.
inline int sign_throughout(const Form& f) {
    const int sign = sgn(f.at_low());
    if (sgn(f.at_high()) != sign) return 0;
    return std::ranges::all_of(f.c, [&](const mpz_class& c) { return sgn(c) * sign >= 0; }) ? sign : 0;
}

inline Forms constant(const Integers& v) {
    return {Form{{v[0]}}, Form{{v[1]}}, Form{{v[2]}}};
}

// A rotation times a positive form.
struct RotationForms {
    std::array<Forms, 3> rows;
    Form factor;

    explicit RotationForms(const std::array<Form, 4>& q) {
        const auto& [w, x, y, z] = q;
        const Form ww = w * w, xx = x * x, yy = y * y, zz = z * z;
        const auto twice = [](const Form& f) { return f + f; };
        rows = {{{ww + xx - yy - zz, twice(x * y - w * z), twice(x * z + w * y)},
                 {twice(x * y + w * z), ww - xx + yy - zz, twice(y * z - w * x)},
                 {twice(x * z - w * y), twice(y * z + w * x), ww - xx - yy + zz}}};
        factor = ww + xx + yy + zz;
    }
    Forms turn(const Integers& g) const {
        Forms turned;
        for (std::size_t k = 0; k < 3; ++k) turned[k] = g[0] * rows[k][0] + g[1] * rows[k][1] + g[2] * rows[k][2];
        return turned;
    }
    // The other way round, at one end of the piece.
    Integers turn_back(const Integers& g, bool is_upper) const {
        Integers turned;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t row = 0; row < 3; ++row) {
                const Form& f = rows[row][k];
                turned[k] += g[row] * (is_upper ? f.at_high() : f.at_low());
            }
        }
        return turned;
    }
};

using FormCorners = std::array<Forms, 3>;

inline Integers without_common_divisor(Integers v) {
    const mpz_class divisor = gcd(gcd(v[0], v[1]), v[2]);
    if (divisor > 1) {
        for (mpz_class& x : v) x /= divisor;
    }
    return v;
}

// True if all corners of one are on the same side of all of the other, along a direction.
inline bool are_apart_along(const Forms& direction, const FormCorners& a, const FormCorners& b) {
    std::array<Form, 3> of_a;
    for (std::size_t i = 0; i < 3; ++i) of_a[i] = dot(direction, a[i]);
    int side = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const Form of_b = dot(direction, b[j]);
        for (std::size_t i = 0; i < 3; ++i) {
            const int sign = sign_throughout(of_b - of_a[i]);
            if (sign == 0 || sign * side < 0) return false;
            side = sign;
        }
    }
    return true;
}

// Features that are closest, and the vector between them; nothing if there are none: the triangles share a point.
struct Closest {
    FeaturePair features;
    Integers way;
};
inline std::optional<Closest> closest(const Corners& corners_a, const Corners& corners_b) {
    const TriangleOf<mpz_class> a(corners_a), b(corners_b);
    std::optional<FeatureDistance<mpz_class>> least;
    const FeaturePair* features = nullptr;
    for (const FeaturePair& pair : feature_pairs()) {
        FeatureDistance<mpz_class> d = feature_distance(pair, a, b);
        if (!d.is_inside) continue;
        if (least && d.num * least->den >= least->num * d.den) continue;
        least = std::move(d);
        features = &pair;
    }
    if (!least || sgn(least->num) == 0) return std::nullopt;
    const auto points = closest_points(*features, a, b);
    Integers way;
    for (std::size_t k = 0; k < 3; ++k) way[k] = points[1].num[k] * points[0].den - points[0].num[k] * points[1].den;
    return Closest{*features, without_common_divisor(way)};
}

// One piece of the time, from `low` to `high` in units of 1 / den.
struct Piece {
    mpz_class low, high, den;
    int depth = 0;

    std::array<Piece, 2> halves() const {
        return {Piece{2 * low, low + high, 2 * den, depth + 1}, Piece{low + high, 2 * high, 2 * den, depth + 1}};
    }
};

inline Corners at_end(const FormCorners& corners, bool is_upper) {
    Corners points;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) points[i][k] = is_upper ? corners[i][k].at_high() : corners[i][k].at_low();
    }
    return points;
}

// One triangle on a piece: its corners, and its edges, each times a positive form.
struct TriangleOnPiece {
    const RotationForms* rotation;  // null if the corners go straight
    FormCorners corners;
    std::array<Forms, 3> edges;

    TriangleOnPiece(const RotationForms& turns, const Forms& pivot, const Form& unit, const Corners& arms)
        : rotation(&turns) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Forms turned = turns.turn(arms[i]);
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = pivot[k] + turned[k] * unit;
            edges[i] = turns.turn(Integers(arms[(i + 1) % 3] - arms[i]));
        }
    }
    explicit TriangleOnPiece(const FormCorners& straight) : rotation(nullptr), corners(straight) {
        for (std::size_t i = 0; i < 3; ++i) edges[i] = corners[(i + 1) % 3] - corners[i];
    }
};

inline FormCorners times(FormCorners corners, const Form& factor) {
    for (Forms& corner : corners) {
        for (Form& x : corner) x = x * factor;
    }
    return corners;
}

// Both triangles on a piece, times the same positive form.
struct PairOnPiece {
    const TriangleOnPiece &first, &second;
    FormCorners a, b;

    // Each is times the factor of its own.
    PairOnPiece(const TriangleOnPiece& of_a, const Form& factor_a, const TriangleOnPiece& of_b, const Form& factor_b)
        : first(of_a), second(of_b), a(times(of_a.corners, factor_b)), b(times(of_b.corners, factor_a)) {}

    bool are_apart() const {
        for (const Integers& axis : {Integers{1, 0, 0}, Integers{0, 1, 0}, Integers{0, 0, 1}}) {
            if (are_apart_along(constant(axis), a, b)) return true;
        }
        return are_apart_between_closest(true) || are_apart_between_closest(false);
    }

  private:
    // Along the way between the closest points at one end of the piece, which stays or turns with one of both; and
    // along the normal of two edges.
    bool are_apart_between_closest(bool is_upper) const {
        const auto found = closest(at_end(a, is_upper), at_end(b, is_upper));
        if (!found) return false;
        if (are_apart_along(constant(found->way), a, b)) return true;
        for (const RotationForms* rotation : {first.rotation, second.rotation}) {
            if (rotation == nullptr) continue;
            const Integers in_body = without_common_divisor(rotation->turn_back(found->way, is_upper));
            if (are_apart_along(rotation->turn(in_body), a, b)) return true;
        }
        if (found->features.kind != Closeness::edge_edge) return false;
        return are_apart_along(cross(first.edges[found->features.a], second.edges[found->features.b]), a, b);
    }
};

}  // namespace ecods::oracle::turn_forms
