#include "oracle/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/oracle.hpp"
#include "oracle/pair_motion.hpp"
#include "oracle/triangle_distance.hpp"

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
    std::array<Vec3, 3> corners(std::uint32_t index) const {
        const Triangle& t = soup.triangles[index];
        return {soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]};
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

std::optional<ExactContact> contact_at_start(const MovingMesh& a, const MovingMesh& b) {
    std::optional<ExactContact> contact;
    const auto add = [&](const TrianglePair& pair) {
        const NamedFeature of_a{2, pair.a, 0}, of_b{2, pair.b, 0};
        if (!contact) contact = {Root(0), 0, Closeness::intersecting, of_a, of_b, of_b, of_a};
        if (std::tie(pair.b, pair.a) < std::tie(contact->b_first.triangle, contact->a_second.triangle)) {
            contact->b_first = of_b;
            contact->a_second = of_a;
        }
    };
    for_each_overlap(a, b, false, [&](const TrianglePair& pair) {
        if (contact && pair.b >= contact->b_first.triangle) return;
        if (triangle_triangle(a.soup.pose, a.corners(pair.a), b.soup.pose, b.corners(pair.b)) == Relation::apart) {
            return;
        }
        add(pair);
    });
    return contact;
}

struct TimedPair {
    TrianglePair pair;
    Root time;
};

// All pairs of triangles whose times round to the least time.
std::vector<TimedPair> first_pairs(const MovingMesh& a, const MovingMesh& b, MakePair make) {
    std::vector<TimedPair> found;
    double least = 2;
    for_each_overlap(a, b, true, [&](const TrianglePair& pair) {
        const MovingTriangle of_a = a.triangle(pair.a), of_b = b.triangle(pair.b);
        if (are_apart(of_a, of_b, std::min(1.0, std::nextafter(least, 2)))) return;
        const auto time = make(of_a, of_b)->first_time();
        if (!time) return;
        const double rounded = time->nearest();
        if (rounded < least) found.clear();
        if (rounded <= least) found.push_back({pair, *time});
        least = std::min(least, rounded);
    });
    return found;
}

// What the rule compares, the first number first.
auto rank(Closeness kind, const NamedFeature& first, const NamedFeature& second) {
    return std::tuple(kind, first.triangle, first.corner, second.triangle, second.corner, first.dimension);
}

std::optional<ExactContact> first_of(const MovingMesh& a, const MovingMesh& b, MakePair make) {
    if (auto contact = contact_at_start(a, b)) return contact;
    std::optional<ExactContact> first;
    for (TimedPair& found : first_pairs(a, b, make)) {
        const auto& [i, j] = found.pair;
        const auto motion = make(a.triangle(i), b.triangle(j));
        if (first && found.time.compare(first->time) < 0) first->time = found.time;
        for (const std::size_t index : motion->features_at(found.time)) {
            const auto& [kind, dimension_a, of_a, dimension_b, of_b] = feature_pairs()[index];
            const NamedFeature in_a{dimension_a, i, of_a}, in_b{dimension_b, j, of_b};
            if (!first) first = {found.time, found.time.nearest(), kind, in_a, in_b, in_b, in_a};
            if (rank(kind, in_a, in_b) < rank(first->kind, first->a, first->b)) {
                first->a = in_a;
                first->b = in_b;
            }
            if (rank(kind, in_b, in_a) < rank(first->kind, first->b_first, first->a_second)) {
                first->b_first = in_b;
                first->a_second = in_a;
            }
            first->kind = std::min(first->kind, kind);
        }
    }
    return first;
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
    return first_of(moving, {b, common.points[1], common.points[1]}, make_translation);
}

std::optional<ExactContact> first_contact(const MovingSoup& a, const MovingSoup& b) {
    const FloatEnvironment environment;
    const std::array<Soup, 4> soups{a.from, Soup{a.from.vertices, a.from.triangles, a.to}, b.from,
                                    Soup{b.from.vertices, b.from.triangles, b.to}};
    CommonIntegers common(soups);
    return first_of({a.from, common.points[0], common.points[1]}, {b.from, common.points[2], common.points[3]},
                    make_motion);
}

}  // namespace ecods::oracle
