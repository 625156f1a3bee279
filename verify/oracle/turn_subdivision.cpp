#include "oracle/turn_subdivision.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "oracle/share_point.hpp"
#include "oracle/turn_forms.hpp"

namespace ecods::oracle {
namespace {

using namespace turn_forms;

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

// How a body is on a piece of the time, or at one time: its rotation, and its pivot times `factor`.
struct BodyOnPiece {
    RotationForms rotation;
    Forms pivot;
    Form unit, factor;
};

}  // namespace

TurnSubdivision::TurnSubdivision(const TurningSoup& a, const Soup& b)
    : TurnSubdivision(a, TurningSoup{b, {1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}) {}

TurnSubdivision::TurnSubdivision(const TurningSoup& a, const TurningSoup& b) : TurnSubdivision(Moved{a}, Moved{b}) {}

TurnSubdivision::TurnSubdivision(const TurningSoup& a, const MovingSoup& b)
    : TurnSubdivision(Moved{a}, Moved{{b.from, {1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}, &b.to}) {}

TurnSubdivision::TurnSubdivision(const Moved& a, const Moved& b) {
    const std::array<const TurningSoup*, 2> soups{&a.soup, &b.soup};
    const std::array<const Pose*, 2> ends{a.end, b.end};
    std::array<std::vector<std::array<Fractions, 3>>, 2> triangles, at_end;
    std::array<std::array<Fractions, 2>, 2> pivots;
    mpz_class unit = 1;  // all denominators are powers of two
    const auto add = [&](const Fractions& point) {
        for (const mpq_class& x : point) unit = std::max(unit, x.get_den());
    };
    for (std::size_t side = 0; side < 2; ++side) {
        triangles[side] = posed(soups[side]->from);
        pivots[side] = {posed(Pose(), soups[side]->pivot_from), posed(Pose(), soups[side]->pivot_to)};
        if (ends[side] != nullptr) {
            at_end[side] = posed(Soup{soups[side]->from.vertices, soups[side]->from.triangles, *ends[side]});
        }
        for (const auto& corners : triangles[side]) std::ranges::for_each(corners, add);
        for (const auto& corners : at_end[side]) std::ranges::for_each(corners, add);
        std::ranges::for_each(pivots[side], add);
    }
    const auto integers = [&](const Fractions& point) {
        return Integers{mpq_class(point[0] * unit).get_num(), mpq_class(point[1] * unit).get_num(),
                        mpq_class(point[2] * unit).get_num()};
    };
    for (std::size_t side = 0; side < 2; ++side) {
        Body& body = bodies_[side];
        body.pivot = integers(pivots[side][0]);
        body.glide = integers(pivots[side][1]) - body.pivot;
        for (const auto& t : triangles[side]) {
            body.arms.push_back(
                {integers(t[0]) - body.pivot, integers(t[1]) - body.pivot, integers(t[2]) - body.pivot});
        }
        for (const auto& t : at_end[side]) body.at_end.push_back({integers(t[0]), integers(t[1]), integers(t[2])});
        const auto& q = soups[side]->q;
        for (const double x : q) body.one = std::max(body.one, mpq_class(x).get_den());
        for (std::size_t i = 0; i < 4; ++i) body.q[i] = mpq_class(mpq_class(q[i]) * body.one).get_num();
        body.rests = q == std::array<double, 4>{1, 0, 0, 0} && body.glide == Integers{};
    }
}

namespace {

// `linear(x, y)` is the form of what goes from x to y in the time from 0 to 1, and `unit` that of what is always 1. A
// body that rests is a constant. The factor of one that goes straight is `unit`.
template <class Body, class Linear>
BodyOnPiece on_piece(const Body& body, const Linear& linear, const Form& unit) {
    if (body.rests || !body.at_end.empty()) {
        const Form one{{1}}, none{{0}};
        return {RotationForms({one, none, none, none}), constant(body.pivot), one, body.at_end.empty() ? one : unit};
    }
    RotationForms rotation(
        {linear(body.one, body.q[0]), linear(0, body.q[1]), linear(0, body.q[2]), linear(0, body.q[3])});
    Forms pivot;
    for (std::size_t k = 0; k < 3; ++k) {
        pivot[k] = rotation.factor * linear(body.pivot[k], body.pivot[k] + body.glide[k]);
    }
    Form factor = rotation.factor * unit;
    return {std::move(rotation), std::move(pivot), unit, std::move(factor)};
}

template <class Body, class Linear>
std::vector<TriangleOnPiece> triangles_on(const BodyOnPiece& on_piece, const Body& body, const Linear& linear) {
    std::vector<TriangleOnPiece> triangles;
    for (std::size_t t = 0; t < body.arms.size(); ++t) {
        if (body.at_end.empty()) {
            triangles.emplace_back(on_piece.rotation, on_piece.pivot, on_piece.unit, body.arms[t]);
            continue;
        }
        FormCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = linear(body.arms[t][i][k], body.at_end[t][i][k]);
        }
        triangles.emplace_back(corners);
    }
    return triangles;
}

}  // namespace

bool TurnSubdivision::are_apart(const mpq_class& from, const mpq_class& to, int depth) const {
    struct Open {
        Piece piece;
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
    };
    const mpz_class den = lcm(from.get_den(), to.get_den());
    Open all{{mpq_class(from * den).get_num(), mpq_class(to * den).get_num(), den}, {}};
    for (std::size_t i = 0; i < bodies_[0].arms.size(); ++i) {
        for (std::size_t j = 0; j < bodies_[1].arms.size(); ++j) all.pairs.emplace_back(i, j);
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
        const Form unit{{piece.den, piece.den}};
        const BodyOnPiece a = on_piece(bodies_[0], linear, unit), b = on_piece(bodies_[1], linear, unit);
        const auto of_a = triangles_on(a, bodies_[0], linear), of_b = triangles_on(b, bodies_[1], linear);
        std::vector<std::pair<std::size_t, std::size_t>> left;
        for (const auto& [i, j] : next.pairs) {
            const PairOnPiece pair(of_a[i], a.factor, of_b[j], b.factor);
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
    const auto at = [&](const mpz_class& at_0, const mpz_class& at_1) {
        return Form{{at_0 * (den - num) + at_1 * num}};
    };
    const BodyOnPiece a = on_piece(bodies_[0], at, Form{{den}}), b = on_piece(bodies_[1], at, Form{{den}});
    const auto of_a = triangles_on(a, bodies_[0], at), of_b = triangles_on(b, bodies_[1], at);
    for (const TriangleOnPiece& first : of_a) {
        for (const TriangleOnPiece& second : of_b) {
            const PairOnPiece pair(first, a.factor, second, b.factor);
            if (share_point(at_end(pair.a, true), at_end(pair.b, true))) return true;
        }
    }
    return false;
}

}  // namespace ecods::oracle
