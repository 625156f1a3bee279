#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/pairs_on_the_way.hpp"

namespace ecods::oracle {
namespace {

using Integers = Vector<mpz_class>;
using Polynomials = Vector<Polynomial>;

// The quaternion of the time, 1 + s (q - 1), in the unit in which 1 and q are integers.
struct QuaternionOfTime {
    Polynomial real;
    Polynomials axis;
    Polynomial squared_length;
    Integers fixed_axis;  // of which `axis` is a multiple, at each time

    explicit QuaternionOfTime(const std::array<double, 4>& q) {
        mpz_class one = 1;
        for (const double x : q) one = std::max(one, mpq_class(x).get_den());  // all are powers of two
        const auto in_units = [&](double x) { return mpq_class(mpq_class(x) * one).get_num(); };
        real = Polynomial({one, in_units(q[0]) - one});
        for (std::size_t k = 0; k < 3; ++k) {
            fixed_axis[k] = in_units(q[k + 1]);
            axis[k] = Polynomial({0, fixed_axis[k]});
        }
        squared_length = real * real + dot(axis, axis);
    }

    // The vector turned, times the squared length: the product of the quaternion, the vector, and the conjugate.
    Polynomials turn(const Integers& g) const {
        const Polynomials fixed{Polynomial({g[0]}), Polynomial({g[1]}), Polynomial({g[2]})};
        const Polynomial minus_scalar = dot(axis, fixed);
        Polynomials vector = cross(axis, fixed);
        for (std::size_t k = 0; k < 3; ++k) vector[k] = vector[k] + real * fixed[k];
        Polynomials turned = cross(axis, vector);
        for (std::size_t k = 0; k < 3; ++k) turned[k] = turned[k] + real * vector[k] + minus_scalar * axis[k];
        return turned;
    }
};

struct Range {
    mpz_class min, max;

    void add(const mpz_class& x) {
        if (x < min) min = x;
        if (x > max) max = x;
    }
    bool overlaps(const Range& other) const { return min <= other.max && other.min <= max; }
};

// Ranges along the coordinate axes and along the axis of the turn.
using Ranges = std::array<Range, 4>;

bool overlap(const Ranges& a, const Ranges& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (!a[k].overlaps(b[k])) return false;
    }
    return true;
}

Ranges ranges_around(const std::vector<Integers>& points, const Triangle& t, const Integers& axis) {
    Ranges ranges;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto along = [&](const Integers& p) { return k < 3 ? p[k] : dot(axis, p); };
        ranges[k] = {along(points[t[0]]), along(points[t[0]])};
        for (const std::uint32_t vertex : t) ranges[k].add(along(points[vertex]));
    }
    return ranges;
}

// One soup that turns: its corners on their way, times the squared length of its quaternion.
class TurningSide {
  public:
    TurningSide(const TurningSoup& soup, const std::vector<Integers>& points, const std::vector<Integers>& pivots)
        : q_(soup.q), triangles_(soup.from.triangles), points_(points), from_(pivots[0]) {
        for (std::size_t k = 0; k < 3; ++k) {
            glide_[k] = pivots[1][k] - from_[k];
            pivot_[k] = Polynomial({from_[k], glide_[k]}) * q_.squared_length;
        }
    }

    const QuaternionOfTime& quaternion() const { return q_; }

    PolynomialCorners corners(std::uint32_t index) const {
        PolynomialCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers& p = points_[triangles_[index][i]];
            corners[i] = q_.turn(Integers(p - from_));
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = corners[i][k] + pivot_[k];
        }
        return corners;
    }

    // The places of a triangle that turns: within the largest distance of a corner from the pivot, on each axis; and
    // along the axis of the turn only the pivot moves.
    Ranges on_the_way(const Triangle& t) const {
        mpz_class farthest = 0;
        for (const std::uint32_t vertex : t) {
            const Integers g = points_[vertex] - from_;
            farthest = std::max(farthest, mpz_class(dot(g, g)));
        }
        const mpz_class radius = sqrt(farthest) + 1;  // rounded down, and up
        Ranges ranges = ranges_around(points_, t, q_.fixed_axis);
        for (std::size_t k = 0; k < 3; ++k) {
            ranges[k] = {from_[k], from_[k]};
            ranges[k].add(from_[k] + glide_[k]);
            ranges[k].min -= radius;
            ranges[k].max += radius;
        }
        const mpz_class along = dot(q_.fixed_axis, glide_);
        sgn(along) < 0 ? ranges[3].min += along : ranges[3].max += along;
        return ranges;
    }

  private:
    QuaternionOfTime q_;
    std::span<const Triangle> triangles_;
    const std::vector<Integers>& points_;
    Integers from_, glide_;
    Polynomials pivot_;  // on its way, times the squared length
};

constexpr std::array<Triangle, 1> segment{{{0, 1, 1}}};

PolynomialCorners times(PolynomialCorners corners, const Polynomial& factor) {
    for (Polynomials& corner : corners) {
        for (Polynomial& x : corner) x = x * factor;
    }
    return corners;
}

PairsOnTheWay pairs_of(const Soup& a, const Soup& b, const std::vector<Ranges>& of_a, const std::vector<Ranges>& of_b) {
    PairsOnTheWay result{a, b, {}, {}, {}, {}};
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
        for (std::uint32_t j = 0; j < of_b.size(); ++j) {
            if (overlap(of_a[i], of_b[j])) result.on_the_way.push_back({i, j});
        }
    }
    result.at_start = result.on_the_way;
    result.are_apart = [](const TrianglePair&, double) { return false; };
    return result;
}

class TurningPairs {
  public:
    TurningPairs(const TurningSoup& a, const Soup& b)
        : a_(a.from),
          b_(b),
          places_{a.pivot_from, a.pivot_to},
          common_(soups()),
          side_(a, common_.points[0], common_.points[2]) {}

    PairsOnTheWay pairs() const {
        std::vector<Ranges> of_a, of_b;
        for (const Triangle& t : a_.triangles) of_a.push_back(side_.on_the_way(t));
        for (const Triangle& t : b_.triangles) {
            of_b.push_back(ranges_around(common_.points[1], t, side_.quaternion().fixed_axis));
        }
        PairsOnTheWay result = pairs_of(a_, b_, of_a, of_b);
        result.motion = [this](const TrianglePair& pair) {
            return make_motion(side_.corners(pair.a), still(pair.b), side_.quaternion().squared_length);
        };
        return result;
    }

  private:
    std::array<Soup, 3> soups() const { return {a_, b_, Soup{places_, segment, Pose()}}; }

    PolynomialCorners still(std::uint32_t index) const {
        PolynomialCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers& p = common_.points[1][b_.triangles[index][i]];
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = Polynomial({p[k]}) * side_.quaternion().squared_length;
        }
        return corners;
    }

    Soup a_, b_;
    std::array<Vec3, 2> places_;
    CommonIntegers common_;
    TurningSide side_;
};

// Leaves out the range along the axis of a turn: the axes of two turns are not the same, and a straight motion has
// none.
Ranges without_axis(Ranges ranges) {
    ranges[3] = {0, 0};
    return ranges;
}

// Coordinates of two bodies that turn are times both squared lengths.
class BothTurningPairs {
  public:
    BothTurningPairs(const TurningSoup& a, const TurningSoup& b)
        : a_(a.from),
          b_(b.from),
          places_{a.pivot_from, a.pivot_to, b.pivot_from, b.pivot_to},
          common_(soups()),
          side_a_(a, common_.points[0], common_.points[2]),
          side_b_(b, common_.points[1], common_.points[3]) {}

    PairsOnTheWay pairs() const {
        std::vector<Ranges> of_a, of_b;
        for (const Triangle& t : a_.triangles) of_a.push_back(without_axis(side_a_.on_the_way(t)));
        for (const Triangle& t : b_.triangles) of_b.push_back(without_axis(side_b_.on_the_way(t)));
        PairsOnTheWay result = pairs_of(a_, b_, of_a, of_b);
        result.motion = [this](const TrianglePair& pair) {
            const Polynomial &norm_a = side_a_.quaternion().squared_length,
                             &norm_b = side_b_.quaternion().squared_length;
            return make_motion(times(side_a_.corners(pair.a), norm_b), times(side_b_.corners(pair.b), norm_a),
                               norm_a * norm_b);
        };
        return result;
    }

  private:
    std::array<Soup, 4> soups() const {
        const std::span<const Vec3> places(places_);
        return {a_, b_, Soup{places.first(2), segment, Pose()}, Soup{places.last(2), segment, Pose()}};
    }

    Soup a_, b_;
    std::array<Vec3, 4> places_;
    CommonIntegers common_;
    TurningSide side_a_, side_b_;
};

class TurnAndStraightPairs {
  public:
    TurnAndStraightPairs(const TurningSoup& a, const MovingSoup& b)
        : a_(a.from),
          b_(b.from),
          b_at_end_{b.from.vertices, b.from.triangles, b.to},
          places_{a.pivot_from, a.pivot_to},
          common_(soups()),
          side_(a, common_.points[0], common_.points[2]) {}

    PairsOnTheWay pairs() const {
        std::vector<Ranges> of_a, of_b;
        for (const Triangle& t : a_.triangles) of_a.push_back(without_axis(side_.on_the_way(t)));
        for (const Triangle& t : b_.triangles) of_b.push_back(ranges_of_way(t));
        PairsOnTheWay result = pairs_of(a_, b_, of_a, of_b);
        result.motion = [this](const TrianglePair& pair) {
            const Polynomial& norm = side_.quaternion().squared_length;
            return make_motion(side_.corners(pair.a), times(straight_corners(pair.b), norm), norm);
        };
        return result;
    }

  private:
    std::array<Soup, 4> soups() const { return {a_, b_, Soup{places_, segment, Pose()}, b_at_end_}; }
    Ranges ranges_of_way(const Triangle& t) const {
        Ranges ranges = ranges_around(common_.points[1], t, Integers{});
        const Ranges at_end = ranges_around(common_.points[3], t, Integers{});
        for (std::size_t k = 0; k < 3; ++k) {
            ranges[k].add(at_end[k].min);
            ranges[k].add(at_end[k].max);
        }
        return ranges;
    }
    PolynomialCorners straight_corners(std::uint32_t index) const {
        PolynomialCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = b_.triangles[index][i];
            const Integers &from = common_.points[1][vertex], &to = common_.points[3][vertex];
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = Polynomial({from[k], to[k] - from[k]});
        }
        return corners;
    }

    Soup a_, b_, b_at_end_;
    std::array<Vec3, 2> places_;
    CommonIntegers common_;
    TurningSide side_;
};

}  // namespace

std::optional<ExactContact> first_contact(const TurningSoup& a, const Soup& b) {
    const FloatEnvironment environment;
    const TurningPairs turning(a, b);
    return first_of(turning.pairs());
}

std::optional<ExactContact> first_contact(const TurningSoup& a, const TurningSoup& b) {
    const FloatEnvironment environment;
    const BothTurningPairs turning(a, b);
    return first_of(turning.pairs());
}

std::optional<ExactContact> first_contact(const TurningSoup& a, const MovingSoup& b) {
    const FloatEnvironment environment;
    const TurnAndStraightPairs pairs(a, b);
    return first_of(pairs.pairs());
}

}  // namespace ecods::oracle
