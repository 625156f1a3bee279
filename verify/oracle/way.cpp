#include "oracle/way.hpp"

#include <algorithm>
#include <utility>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/pairs_on_the_way.hpp"
#include "oracle/rational_rotation.hpp"
#include "oracle/share_point.hpp"

namespace ecods::oracle {
namespace {

using Integers = Vector<mpz_class>;

constexpr std::array<Triangle, 1> segment{{{0, 1, 1}}};

// All of a leg and of the other body in one unit, and both quaternions in their own.
class Leg {
  public:
    Leg(const LegSoup& a, const Soup& b)
        : a_(a.start), b_(b), places_{a.pivot, a.pivot_from}, end_{a.pivot_to, a.pivot_to}, common_(soups()) {
        mpz_class one = 1;  // all denominators are powers of two
        for (const auto* q : {&a.from, &a.to}) {
            for (const double x : *q) one = std::max(one, mpq_class(x).get_den());
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const mpz_class first = mpq_class(mpq_class(a.from[i]) * one).get_num(),
                            last = mpq_class(mpq_class(a.to[i]) * one).get_num();
            q_[i] = Polynomial({first, last - first});
        }
        rotation_ = rotation_of(q_);
        norm_ = q_[0] * q_[0] + q_[1] * q_[1] + q_[2] * q_[2] + q_[3] * q_[3];
    }

    PairsOnTheWay pairs(bool is_first) const {
        PairsOnTheWay result{a_, b_, {}, {}, {}, {}};
        for (std::uint32_t i = 0; i < a_.triangles.size(); ++i) {
            for (std::uint32_t j = 0; j < b_.triangles.size(); ++j) {
                if (may_meet(a_.triangles[i], b_.triangles[j])) result.on_the_way.push_back({i, j});
            }
        }
        if (is_first) result.at_start = result.on_the_way;
        result.are_apart = [](const TrianglePair&, double) { return false; };
        result.motion = [this](const TrianglePair& pair) { return motion(pair); };
        return result;
    }

    std::unique_ptr<PairMotion> motion(const TrianglePair& pair) const {
        PolynomialCorners turning, still;
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers g = common_.points[0][a_.triangles[pair.a][i]] - common_.points[2][0];
            const Integers& y = common_.points[1][b_.triangles[pair.b][i]];
            for (std::size_t k = 0; k < 3; ++k) {
                const mpz_class& from = common_.points[2][1][k];
                turning[i][k] = norm_ * Polynomial({from, common_.points[3][0][k] - from}) +
                                Polynomial({g[0]}) * rotation_[k][0] + Polynomial({g[1]}) * rotation_[k][1] +
                                Polynomial({g[2]}) * rotation_[k][2];
                still[i][k] = norm_ * Polynomial({y[k]});
            }
        }
        return make_motion(turning, still, norm_);
    }

  private:
    std::array<Soup, 4> soups() const { return {a_, b_, Soup{places_, segment, Pose()}, Soup{end_, segment, Pose()}}; }
    // False if the boxes of all places of both triangles are apart: a corner is never farther from the pivot than at
    // the start.
    bool may_meet(const Triangle& t, const Triangle& other) const {
        mpz_class farthest = 0;
        for (const std::uint32_t vertex : t) {
            const Integers g = common_.points[0][vertex] - common_.points[2][0];
            farthest = std::max(farthest, mpz_class(dot(g, g)));
        }
        const mpz_class radius = sqrt(farthest) + 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [low, high] = std::minmax(common_.points[2][1][k], common_.points[3][0][k]);
            const auto is_beyond = [&](int sign) {
                return std::ranges::all_of(other, [&](std::uint32_t vertex) {
                    const mpz_class& y = common_.points[1][vertex][k];
                    return sign > 0 ? y > high + radius : y < low - radius;
                });
            };
            if (is_beyond(1) || is_beyond(-1)) return false;
        }
        return true;
    }

    Soup a_, b_;
    std::array<Vec3, 2> places_, end_;
    CommonIntegers common_;
    std::array<Polynomial, 4> q_;
    std::array<Vector<Polynomial>, 3> rotation_;
    Polynomial norm_;
};

Corners corners_of(const std::vector<Integers>& points, const Triangle& t) {
    return {points[t[0]], points[t[1]], points[t[2]]};
}

Corners ways_between(const Corners& from, const Corners& to) {
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

}  // namespace

std::optional<ExactWayContact> first_contact(const WaySoup& a, const Soup& b) {
    const FloatEnvironment environment;
    for (std::size_t k = 0; k + 1 < a.quaternions.size(); ++k) {
        const Leg leg(a.leg(k), b);
        if (auto contact = first_of(leg.pairs(k == 0))) return ExactWayContact{k, *contact};
    }
    return std::nullopt;
}

std::unique_ptr<PairMotion> motion_of_pair(const LegSoup& a, const Soup& b, const TrianglePair& pair) {
    const FloatEnvironment environment;
    return Leg(a, b).motion(pair);
}

std::optional<ExactContact> settling_contact(const LegSoup& a, const Pose& to, const Soup& b) {
    const FloatEnvironment environment;
    const std::array<Vec3, 2> places{a.pivot, a.pivot_to};
    const Soup goal{a.start.vertices, a.start.triangles, to};
    const CommonIntegers common(std::array{a.start, b, goal, Soup{places, segment, Pose()}});
    const RationalRotation end(a.to, a.to, 0);
    // Times the denominator of the rotation's entries.
    mpz_class unit = 1;
    for (const auto& row : end.rows) {
        for (const mpq_class& x : row) unit = lcm(unit, x.get_den());
    }
    std::vector<Integers> from, still, last;
    for (const Integers& p : common.points[0]) {
        const Integers g = p - common.points[3][0];
        Integers x;
        for (std::size_t k = 0; k < 3; ++k) {
            mpq_class sum = common.points[3][1][k];
            for (std::size_t i = 0; i < 3; ++i) sum += end.rows[k][i] * g[i];
            x[k] = mpq_class(sum * unit).get_num();
        }
        from.push_back(x);
    }
    const auto times_unit = [&](const Integers& p) { return Integers{p[0] * unit, p[1] * unit, p[2] * unit}; };
    std::ranges::transform(common.points[1], std::back_inserter(still), times_unit);
    std::ranges::transform(common.points[2], std::back_inserter(last), times_unit);
    const auto of_a = [&](std::uint32_t i) { return corners_of(from, a.start.triangles[i]); };
    const auto of_b = [&](std::uint32_t j) { return corners_of(still, b.triangles[j]); };
    PairsOnTheWay pairs{a.start, b, {}, {}, {}, {}};
    for (std::uint32_t i = 0; i < a.start.triangles.size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
            if (share_point(of_a(i), of_b(j))) {
                const NamedFeature face_a{2, i, 0}, face_b{2, j, 0};
                return ExactContact{Root(0), 0, Closeness::intersecting, face_a, face_b, face_b, face_a};
            }
            pairs.on_the_way.push_back({i, j});
        }
    }
    pairs.are_apart = [](const TrianglePair&, double) { return false; };
    pairs.motion = [&](const TrianglePair& pair) {
        const Corners start = of_a(pair.a), rest = of_b(pair.b);
        const Corners end_corners = corners_of(last, a.start.triangles[pair.a]);
        return make_motion(MovingTriangle{start, ways_between(start, end_corners)}, MovingTriangle{rest, {}});
    };
    return first_of(pairs);
}

}  // namespace ecods::oracle
