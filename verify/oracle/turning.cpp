#include <algorithm>
#include <array>
#include <utility>

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

class TurningPairs {
  public:
    TurningPairs(const TurningSoup& a, const Soup& b)
        : a_(a.from), b_(b), q_(a.q), places_{a.pivot_from, a.pivot_to}, common_(soups()) {
        for (std::size_t k = 0; k < 3; ++k) {
            glide_[k] = common_.points[2][1][k] - pivot()[k];
            pivot_[k] = Polynomial({pivot()[k], glide_[k]}) * q_.squared_length;
        }
    }

    PairsOnTheWay pairs() const {
        PairsOnTheWay result{a_, b_, {}, {}, {}, {}};
        std::vector<Ranges> of_a, of_b;
        for (const Triangle& t : a_.triangles) of_a.push_back(on_the_way(t));
        for (const Triangle& t : b_.triangles) of_b.push_back(around(common_.points[1], t));
        for (std::uint32_t i = 0; i < of_a.size(); ++i) {
            for (std::uint32_t j = 0; j < of_b.size(); ++j) {
                if (overlap(of_a[i], of_b[j])) result.on_the_way.push_back({i, j});
            }
        }
        result.at_start = result.on_the_way;
        result.are_apart = [](const TrianglePair&, double) { return false; };
        result.motion = [this](const TrianglePair& pair) {
            return make_motion(turning(pair.a), still(pair.b), q_.squared_length);
        };
        return result;
    }

  private:
    static constexpr std::array<Triangle, 1> segment{{{0, 1, 1}}};

    std::array<Soup, 3> soups() const { return {a_, b_, Soup{places_, segment, Pose()}}; }
    const Integers& pivot() const { return common_.points[2][0]; }

    PolynomialCorners turning(std::uint32_t index) const {
        PolynomialCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers& p = common_.points[0][a_.triangles[index][i]];
            corners[i] = q_.turn(Integers(p - pivot()));
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = corners[i][k] + pivot_[k];
        }
        return corners;
    }
    PolynomialCorners still(std::uint32_t index) const {
        PolynomialCorners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers& p = common_.points[1][b_.triangles[index][i]];
            for (std::size_t k = 0; k < 3; ++k) corners[i][k] = Polynomial({p[k]}) * q_.squared_length;
        }
        return corners;
    }

    Ranges around(const std::vector<Integers>& points, const Triangle& t) const {
        Ranges ranges;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto along = [&](const Integers& p) { return k < 3 ? p[k] : dot(q_.fixed_axis, p); };
            ranges[k] = {along(points[t[0]]), along(points[t[0]])};
            for (const std::uint32_t vertex : t) ranges[k].add(along(points[vertex]));
        }
        return ranges;
    }
    // The places of a triangle that turns: within the largest distance of a corner from the pivot, on each axis; and
    // along the axis of the turn only the pivot moves.
    Ranges on_the_way(const Triangle& t) const {
        mpz_class farthest = 0;
        for (const std::uint32_t vertex : t) {
            const Integers g = common_.points[0][vertex] - pivot();
            farthest = std::max(farthest, mpz_class(dot(g, g)));
        }
        const mpz_class radius = sqrt(farthest) + 1;  // rounded down, and up
        Ranges ranges = around(common_.points[0], t);
        for (std::size_t k = 0; k < 3; ++k) {
            ranges[k] = {pivot()[k], pivot()[k]};
            ranges[k].add(pivot()[k] + glide_[k]);
            ranges[k].min -= radius;
            ranges[k].max += radius;
        }
        const mpz_class along = dot(q_.fixed_axis, glide_);
        sgn(along) < 0 ? ranges[3].min += along : ranges[3].max += along;
        return ranges;
    }

    Soup a_, b_;
    QuaternionOfTime q_;
    std::array<Vec3, 2> places_;
    CommonIntegers common_;
    Integers glide_;
    Polynomials pivot_;  // on its way, times the squared length
};

}  // namespace

std::optional<ExactContact> first_contact(const TurningSoup& a, const Soup& b) {
    const FloatEnvironment environment;
    const TurningPairs turning(a, b);
    return first_of(turning.pairs());
}

}  // namespace ecods::oracle
