#include "oracle/first_contact.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/oracle.hpp"
#include "oracle/pairs_on_the_way.hpp"

namespace ecods::oracle {
namespace {

using Integers = Vector<mpz_class>;
using MakePair = std::unique_ptr<PairMotion> (*)(const MovingTriangle& a, const MovingTriangle& b);

struct Box {
    Integers min, max;

    void add(const Integers& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (p[k] < min[k]) min[k] = p[k];
            if (p[k] > max[k]) max[k] = p[k];
        }
    }
    bool overlaps(const Box& other) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (min[k] > other.max[k] || other.min[k] > max[k]) return false;
        }
        return true;
    }
};

// A mesh at time 0 and at time 1.
struct MovingMesh {
    Soup soup;
    std::vector<Integers> from, to;

    MovingTriangle triangle(std::uint32_t index) const {
        MovingTriangle result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = soup.triangles[index][i];
            result.from[i] = from[vertex];
            result.change[i] = to[vertex] - from[vertex];
        }
        return result;
    }
    // One of each triangle, on all its way, or where it begins.
    std::vector<Box> boxes(bool is_of_all) const {
        std::vector<Box> boxes;
        for (const Triangle& t : soup.triangles) {
            Box box{from[t[0]], from[t[0]]};
            for (const std::uint32_t vertex : t) {
                box.add(from[vertex]);
                if (is_of_all) box.add(to[vertex]);
            }
            boxes.push_back(std::move(box));
        }
        return boxes;
    }
};

template <class Call>
void for_each_overlap(const MovingMesh& a, const MovingMesh& b, bool is_of_all, const Call& call) {
    const std::vector<Box> of_a = a.boxes(is_of_all), of_b = b.boxes(is_of_all);
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
        for (std::uint32_t j = 0; j < of_b.size(); ++j) {
            if (of_a[i].overlaps(of_b[j])) call(TrianglePair{i, j});
        }
    }
}

// In units of the time's denominator.
std::array<Integers, 3> corners_at(const MovingTriangle& triangle, const mpq_class& time) {
    std::array<Integers, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            corners[i][k] = triangle.from[i][k] * time.get_den() + triangle.change[i][k] * time.get_num();
        }
    }
    return corners;
}

// The sign of all differences of the projections of corners of b and of a; 0 if they have no common one.
int side(const Integers& axis, const std::array<Integers, 3>& a, const std::array<Integers, 3>& b) {
    int common = 0;
    for (const Integers& p : a) {
        const mpz_class at = dot(axis, p);
        for (const Integers& q : b) {
            const int sign = sgn(mpz_class(dot(axis, q) - at));
            if (sign == 0 || sign * common < 0) return 0;
            common = sign;
        }
    }
    return common;
}

// Whether some line has the projections of the triangles apart at time 0 and at the time, and so in between, as corners
// move on straight lines.
bool are_apart(const MovingTriangle& a, const MovingTriangle& b, double until) {
    const mpq_class time(until);
    const std::array<Integers, 3> from_a = a.from, from_b = b.from, to_a = corners_at(a, time),
                                  to_b = corners_at(b, time);
    const auto is_on = [&](const Integers& axis) {
        const int at_start = side(axis, from_a, from_b);
        return at_start != 0 && side(axis, to_a, to_b) == at_start;
    };
    for (int x = 0; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (is_on({x, y, z})) return true;
            }
        }
    }
    for (const auto& t : {from_a, from_b, to_a, to_b}) {
        if (is_on(cross(Integers(t[1] - t[0]), Integers(t[2] - t[0])))) return true;
    }
    return false;
}

PairsOnTheWay pairs_of(const MovingMesh& a, const MovingMesh& b, MakePair make) {
    PairsOnTheWay pairs{a.soup, b.soup, {}, {}, {}, {}};
    for_each_overlap(a, b, false, [&](const TrianglePair& pair) { pairs.at_start.push_back(pair); });
    for_each_overlap(a, b, true, [&](const TrianglePair& pair) { pairs.on_the_way.push_back(pair); });
    pairs.are_apart = [&](const TrianglePair& pair, double until) {
        return are_apart(a.triangle(pair.a), b.triangle(pair.b), until);
    };
    pairs.motion = [&a, &b, make](const TrianglePair& pair) { return make(a.triangle(pair.a), b.triangle(pair.b)); };
    return pairs;
}

}  // namespace

std::optional<ExactContact> first_contact(const Soup& a, const Vec3& motion, const Soup& b) {
    const FloatEnvironment environment;
    constexpr std::array<Triangle, 1> one{{{0, 0, 0}}};
    const std::array<Vec3, 1> by{motion};
    const std::array<Soup, 3> soups{a, b, Soup{by, one, Pose()}};
    CommonIntegers common(soups);
    MovingMesh moving{a, common.points[0], {}};
    for (const Integers& p : moving.from) {
        const Integers& m = common.points[2][0];
        moving.to.push_back({p[0] + m[0], p[1] + m[1], p[2] + m[2]});
    }
    const MovingMesh still{b, common.points[1], common.points[1]};
    return first_of(pairs_of(moving, still, make_translation));
}

std::optional<ExactContact> first_contact(const MovingSoup& a, const MovingSoup& b) {
    return first_contact(DeformingSoup{a.from, {a.from.vertices, a.from.triangles, a.to}},
                         DeformingSoup{b.from, {b.from.vertices, b.from.triangles, b.to}});
}

std::optional<ExactContact> first_contact(const DeformingSoup& a, const DeformingSoup& b) {
    const FloatEnvironment environment;
    const std::array<Soup, 4> soups{a.from, a.to, b.from, b.to};
    CommonIntegers common(soups);
    const MovingMesh of_a{a.from, common.points[0], common.points[1]}, of_b{b.from, common.points[2], common.points[3]};
    return first_of(pairs_of(of_a, of_b, make_motion));
}

}  // namespace ecods::oracle
