#include "oracle/turn_subdivision.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "oracle/linear_program.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

using Integers = Vector<mpz_class>;
using Corners = std::array<Integers, 3>;

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
int sign_throughout(const Form& f) {
    const int sign = sgn(f.at_low());
    if (sgn(f.at_high()) != sign) return 0;
    return std::ranges::all_of(f.c, [&](const mpz_class& c) { return sgn(c) * sign >= 0; }) ? sign : 0;
}

Forms constant(const Integers& v) {
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

Integers without_common_divisor(Integers v) {
    const mpz_class divisor = gcd(gcd(v[0], v[1]), v[2]);
    if (divisor > 1) {
        for (mpz_class& x : v) x /= divisor;
    }
    return v;
}

// True if all corners of one are on the same side of all of the other, along a direction.
bool are_apart_along(const Forms& direction, const FormCorners& a, const FormCorners& b) {
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
std::optional<Closest> closest(const Corners& corners_a, const Corners& corners_b) {
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

Corners at_end(const FormCorners& corners, bool is_upper) {
    Corners points;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) points[i][k] = is_upper ? corners[i][k].at_high() : corners[i][k].at_low();
    }
    return points;
}

// Both triangles on a piece, times the same positive form.
struct PairOnPiece {
    const RotationForms& rotation;
    const Corners& arms;
    const Corners& still;
    FormCorners a, b;

    PairOnPiece(const RotationForms& turns, const Forms& pivot, const Form& unit, const Corners& of_a,
                const Corners& of_b)
        : rotation(turns), arms(of_a), still(of_b) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Forms turned = rotation.turn(arms[i]);
            for (std::size_t k = 0; k < 3; ++k) {
                a[i][k] = pivot[k] + turned[k] * unit;
                b[i][k] = still[i][k] * (rotation.factor * unit);
            }
        }
    }

    bool are_apart() const {
        for (const Integers& axis : {Integers{1, 0, 0}, Integers{0, 1, 0}, Integers{0, 0, 1}}) {
            if (are_apart_along(constant(axis), a, b)) return true;
        }
        return are_apart_between_closest(true) || are_apart_between_closest(false);
    }

  private:
    // Along the way between the closest points at one end of the piece, which stays or turns with a; and along the
    // normal of two edges.
    bool are_apart_between_closest(bool is_upper) const {
        const auto found = closest(at_end(a, is_upper), at_end(b, is_upper));
        if (!found) return false;
        if (are_apart_along(constant(found->way), a, b)) return true;
        const Integers in_a = without_common_divisor(rotation.turn_back(found->way, is_upper));
        if (are_apart_along(rotation.turn(in_a), a, b)) return true;
        if (found->features.kind != Closeness::edge_edge) return false;
        const auto edge = [](const Corners& corners, std::size_t i) -> Integers {
            return corners[(i + 1) % 3] - corners[i];
        };
        const Forms normal =
            cross(rotation.turn(edge(arms, found->features.a)), constant(edge(still, found->features.b)));
        return are_apart_along(normal, a, b);
    }
};

// True if weights of the corners of one make a point of the other.
bool share_point(const Corners& a, const Corners& b) {
    std::vector<Equation> equations(5, Equation(7));
    equations[0] = {1, 1, 1, 0, 0, 0, 1};
    equations[1] = {0, 0, 0, 1, 1, 1, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            equations[2 + k][i] = a[i][k] - b[0][k];
            equations[2 + k][3 + i] = b[0][k] - b[i][k];
        }
    }
    return least_first_variable(std::move(equations)).has_value();
}

using Fractions = Vector<mpq_class>;

Fractions posed(const Pose& pose, const Vec3& v) {
    Fractions point;
    for (int k = 0; k < 3; ++k) {
        point[static_cast<std::size_t>(k)] = pose.t[k];
        for (int i = 0; i < 3; ++i) {
            point[static_cast<std::size_t>(k)] += mpq_class(pose.R(k, i)) * mpq_class(v[i]);
        }
    }
    return point;
}

std::vector<std::array<Fractions, 3>> posed(const Soup& soup) {
    std::vector<std::array<Fractions, 3>> triangles;
    for (const Triangle& t : soup.triangles) {
        triangles.push_back({posed(soup.pose, soup.vertices[t[0]]), posed(soup.pose, soup.vertices[t[1]]),
                             posed(soup.pose, soup.vertices[t[2]])});
    }
    return triangles;
}

}  // namespace

TurnSubdivision::TurnSubdivision(const TurningSoup& a, const Soup& b) : one_(1) {
    const auto turning = posed(a.from), still = posed(b);
    const Fractions from = posed(Pose(), a.pivot_from), to = posed(Pose(), a.pivot_to);
    mpz_class unit = 1;  // all denominators are powers of two
    const auto add = [&](const Fractions& point) {
        for (const mpq_class& x : point) unit = std::max(unit, x.get_den());
    };
    for (const auto* triangles : {&turning, &still}) {
        for (const auto& corners : *triangles) std::ranges::for_each(corners, add);
    }
    add(from);
    add(to);
    const auto integers = [&](const Fractions& point) {
        return Integers{mpq_class(point[0] * unit).get_num(), mpq_class(point[1] * unit).get_num(),
                        mpq_class(point[2] * unit).get_num()};
    };
    pivot_ = integers(from);
    glide_ = integers(to) - pivot_;
    for (const auto& t : turning) {
        arms_.push_back({integers(t[0]) - pivot_, integers(t[1]) - pivot_, integers(t[2]) - pivot_});
    }
    for (const auto& t : still) still_.push_back({integers(t[0]), integers(t[1]), integers(t[2])});
    for (const double x : a.q) one_ = std::max(one_, mpq_class(x).get_den());
    for (std::size_t i = 0; i < 4; ++i) q_[i] = mpq_class(mpq_class(a.q[i]) * one_).get_num();
}

bool TurnSubdivision::are_apart(const mpq_class& from, const mpq_class& to, int depth) const {
    struct Open {
        Piece piece;
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
    };
    const mpz_class den = lcm(from.get_den(), to.get_den());
    Open all{{mpq_class(from * den).get_num(), mpq_class(to * den).get_num(), den}, {}};
    for (std::size_t i = 0; i < arms_.size(); ++i) {
        for (std::size_t j = 0; j < still_.size(); ++j) all.pairs.emplace_back(i, j);
    }
    std::vector<Open> open{std::move(all)};
    while (!open.empty()) {
        const Open next = std::move(open.back());
        open.pop_back();
        const Piece& piece = next.piece;
        const auto linear = [&](const mpz_class& at_0, const mpz_class& at_1) {
            return Form{{at_0 * (piece.den - piece.low) + at_1 * piece.low,
                         at_0 * (piece.den - piece.high) + at_1 * piece.high}};
        };
        const RotationForms rotation({linear(one_, q_[0]), linear(0, q_[1]), linear(0, q_[2]), linear(0, q_[3])});
        Forms pivot;
        for (std::size_t k = 0; k < 3; ++k) {
            pivot[k] = rotation.factor * linear(pivot_[k], pivot_[k] + glide_[k]);
        }
        std::vector<std::pair<std::size_t, std::size_t>> left;
        for (const auto& [i, j] : next.pairs) {
            const PairOnPiece pair(rotation, pivot, Form{{piece.den, piece.den}}, arms_[i], still_[j]);
            if (!pair.are_apart()) left.emplace_back(i, j);
        }
        if (left.empty()) continue;
        if (piece.depth == depth || piece.low == piece.high) return false;
        for (const Piece& half : piece.halves()) open.push_back({half, left});
    }
    return true;
}

bool TurnSubdivision::meet(const mpq_class& time) const {
    const mpz_class &num = time.get_num(), &den = time.get_den();
    const auto at = [&](const mpz_class& at_0, const mpz_class& at_1) -> mpz_class {
        return at_0 * (den - num) + at_1 * num;
    };
    const RotationForms rotation(
        {Form{{at(one_, q_[0])}}, Form{{at(0, q_[1])}}, Form{{at(0, q_[2])}}, Form{{at(0, q_[3])}}});
    Forms pivot;
    for (std::size_t k = 0; k < 3; ++k) pivot[k] = rotation.factor * Form{{at(pivot_[k], pivot_[k] + glide_[k])}};
    for (const Corners& arms : arms_) {
        for (const Corners& still : still_) {
            const PairOnPiece pair(rotation, pivot, Form{{den}}, arms, still);
            if (share_point(at_end(pair.a, true), at_end(pair.b, true))) return true;
        }
    }
    return false;
}

}  // namespace ecods::oracle
