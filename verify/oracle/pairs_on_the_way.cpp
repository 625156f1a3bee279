#include "oracle/pairs_on_the_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "oracle/oracle.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

std::array<Vec3, 3> corners(const Soup& soup, std::uint32_t index) {
    const Triangle& t = soup.triangles[index];
    return {soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]};
}

std::optional<ExactContact> contact_at_start(const PairsOnTheWay& pairs) {
    std::optional<ExactContact> contact;
    const auto add = [&](const TrianglePair& pair) {
        const NamedFeature of_a{2, pair.a, 0}, of_b{2, pair.b, 0};
        if (!contact) contact = {Root(0), 0, Closeness::intersecting, of_a, of_b, of_b, of_a};
        if (std::tie(pair.b, pair.a) < std::tie(contact->b_first.triangle, contact->a_second.triangle)) {
            contact->b_first = of_b;
            contact->a_second = of_a;
        }
    };
    for (const TrianglePair& pair : pairs.at_start) {
        if (contact && pair.b >= contact->b_first.triangle) continue;
        const Relation relation =
            triangle_triangle(pairs.a.pose, corners(pairs.a, pair.a), pairs.b.pose, corners(pairs.b, pair.b));
        if (relation != Relation::apart) add(pair);
    }
    return contact;
}

struct TimedPair {
    TrianglePair pair;
    Root time;
};

// All pairs of triangles whose times round to the least time.
std::vector<TimedPair> first_pairs(const PairsOnTheWay& pairs) {
    std::vector<TimedPair> found;
    double least = 2;
    for (const TrianglePair& pair : pairs.on_the_way) {
        if (pairs.are_apart(pair, std::min(1.0, std::nextafter(least, 2)))) continue;
        const auto time = pairs.motion(pair)->first_time();
        if (!time) continue;
        const double rounded = time->nearest();
        if (rounded < least) found.clear();
        if (rounded <= least) found.push_back({pair, *time});
        least = std::min(least, rounded);
    }
    return found;
}

// Returns the numbers that the rule compares, the first one first.
auto rank(Closeness kind, const NamedFeature& first, const NamedFeature& second) {
    return std::tuple(kind, first.triangle, first.corner, second.triangle, second.corner, first.dimension);
}

}  // namespace

std::optional<ExactContact> first_of(const PairsOnTheWay& pairs) {
    if (auto contact = contact_at_start(pairs)) return contact;
    std::optional<ExactContact> first;
    for (TimedPair& found : first_pairs(pairs)) {
        const auto& [i, j] = found.pair;
        if (first && found.time.compare(first->time) < 0) first->time = found.time;
        for (const std::size_t index : pairs.motion(found.pair)->features_at(found.time)) {
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

}  // namespace ecods::oracle
