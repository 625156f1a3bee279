#include "oracle/first_contact.hpp"

#include <algorithm>
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

// Calls until the call returns true.
template <class Call>
void for_each_overlap(const MovingMesh& a, const MovingMesh& b, bool is_of_all, const Call& call) {
    const std::vector<Box> of_a = a.boxes(is_of_all), of_b = b.boxes(is_of_all);
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
        for (std::uint32_t j = 0; j < of_b.size(); ++j) {
            if (of_a[i].overlaps(of_b[j]) && call(TrianglePair{i, j})) return;
        }
    }
}

std::optional<ExactContact> contact_at_start(const MovingMesh& a, const MovingMesh& b) {
    std::optional<ExactContact> contact;
    for_each_overlap(a, b, false, [&](const TrianglePair& pair) {
        if (triangle_triangle(a.soup.pose, a.corners(pair.a), b.soup.pose, b.corners(pair.b)) == Relation::disjoint) {
            return false;
        }
        contact = {Root(0), 0, Closeness::intersecting, {2, pair.a, 0}, {2, pair.b, 0}};
        return true;
    });
    return contact;
}

// What the rule compares, the first number first.
auto rank(const ExactContact& c) {
    return std::tuple(c.kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.dimension);
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
        const auto time = make(a.triangle(pair.a), b.triangle(pair.b))->first_time();
        if (!time) return false;
        const double rounded = time->nearest();
        if (rounded < least) found.clear();
        if (rounded <= least) found.push_back({pair, *time});
        least = std::min(least, rounded);
        return false;
    });
    return found;
}

std::optional<ExactContact> first_of(const MovingMesh& a, const MovingMesh& b, MakePair make) {
    if (auto contact = contact_at_start(a, b)) return contact;
    std::optional<ExactContact> first;
    for (TimedPair& found : first_pairs(a, b, make)) {
        const auto& [i, j] = found.pair;
        const auto motion = make(a.triangle(i), b.triangle(j));
        if (first && found.time.compare(first->time) < 0) first->time = found.time;
        for (const std::size_t index : motion->features_at(found.time)) {
            const FeaturePair& features = feature_pairs()[index];
            const Root time = first ? first->time : found.time;
            const ExactContact contact{time,
                                       time.nearest(),
                                       features.kind,
                                       {features.dimension_a, i, features.a},
                                       {features.dimension_b, j, features.b}};
            if (!first || rank(contact) < rank(*first)) first = contact;
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
