#include "query/distance/point_search.hpp"

#include <algorithm>
#include <functional>

#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "geometry/feature_key.hpp"
#include "query/distance/surface_distance.hpp"

namespace ecods {

PointSearch::PointSearch(const Posed<MeshShape>& body, QueryMemory& memory)
    : posed_(body),
      body_(body),
      memory_(memory),
      working_(QueryMemoryAccess::part<Memory>(memory, &QueryMemoryAccess::State::point)),
      counts_(QueryMemoryAccess::state(memory).counts) {}

void PointSearch::find(const Vec3& point) {
    ++counts_.queries;
    at_.t = point;
    touched_.reset();
    axes_.bind({body_.tree.boxes, body_.pose.R}, body_.pose.t - point);
    working_.sieve.start({});
    if (!axes_.are_useful()) return;
    working_.pair.bind(MeshBody(point_shape(), at_).ref(), body_.ref());

    PointWalk& walk = working_.walk;
    walk.node_count = walk.triangle_count = 0;
    walk_point(body_.tree.boxes, axes_, walk);
    counts_.box_tests += walk.node_count;
    counts_.distances.triangle_bounds += walk.triangle_count;
    std::ranges::sort(walk.found, {}, &NearTriangle::lower);
    for (const NearTriangle& near : walk.found) {
        if (near.lower > (touched_ ? 0 : walk.limit)) break;
        take(near);
    }
    working_.sieve.drop();
}

// Encloses the distance of one triangle, and adds it to the sieve. All triangles that contain the point have the lower
// bound 0, so they are taken first.
void PointSearch::take(const NearTriangle& near) {
    DistanceSieve& sieve = working_.sieve;
    const TrianglePair pair{0, near.triangle};
    ++counts_.distances.enclosures;
    const DistanceInterval interval = working_.pair.enclose(pair.a, pair.b);
    if (!sieve.counts(interval.lower)) return;
    DistanceSieve::Open open{interval, pair};
    if (key_of(interval.lower) <= 0) {
        ++counts_.distances.exact;
        const double distance = working_.pair.distance(pair.a, pair.b);
        if (key_of(distance) == 0) touched_ = std::min(touched_.value_or(pair.b), pair.b);
        open.value = open.interval.lower = open.interval.upper = distance;
    }
    if (sieve.take_upper(open.interval.upper, pair)) {
        working_.walk.limit = std::min(working_.walk.limit, axes_.square_above(sieve.upper()));
    }
    sieve.add(open);
}

double PointSearch::round(const DistanceSieve::Open& open) {
    ++counts_.distances.exact;
    if (const auto distance = working_.pair.fixed_distance(open.triangles, open.interval)) return *distance;
    return working_.pair.distance(open.triangles.a, open.triangles.b);
}

double PointSearch::distance() {
    if (!axes_.are_useful()) {
        return as_part(memory_, [&] { return surface::distance(point(), posed_, memory_); });
    }
    if (touched_) return 0;
    // For a few triangles, rounding all their distances costs less than measuring one distance exactly for the slab.
    constexpr std::size_t few = 8;
    TriangleDistances& pair = working_.pair;
    bool has_slab = false;
    const auto value = [&](const DistanceSieve::Open& open,
                           const std::optional<double>& least) -> std::optional<double> {
        if (least && key_of(open.interval.lower) >= key_of(*least)) return {};
        if (has_slab && pair.is_not_nearer(open.triangles)) return {};
        const double distance = round(open);
        if ((!least || key_of(distance) < key_of(*least)) && working_.sieve.open().size() > few && pair.can_refer()) {
            pair.refer_to(open.triangles);
            has_slab = true;
        }
        return distance;
    };
    const std::optional<double> least = working_.sieve.least(value, std::identity(), [](double) { return 0; });
    ECODS_ASSERT(least);
    return *least;
}

ClosestPoints PointSearch::closest() {
    if (!axes_.are_useful()) {
        return as_part(memory_, [&] { return surface::closest(point(), posed_, memory_); });
    }
    TriangleDistances& pair = working_.pair;
    if (touched_) return pair.closest(0, *touched_);
    const auto& open = working_.sieve.keep_least([&](const TrianglePair& x, const TrianglePair& y) {
        ++counts_.distances.exact;
        return pair.compare(x, y);
    });
    return least_closest(open, [&](const TrianglePair& triangles) {
        ++counts_.distances.exact;
        return pair.closest(triangles.a, triangles.b, {}, TriangleDistances::PointA::left_out);
    });
}

std::optional<OnlyFeature> PointSearch::only() const {
    if (!axes_.are_useful() || touched_) return std::nullopt;
    const std::vector<DistanceSieve::Open>& open = working_.sieve.open();
    const auto best = std::ranges::min_element(
        open, {}, [](const DistanceSieve::Open& x) { return std::pair(key_of(x.interval.upper), x.triangles); });
    if (best == open.end() || !best->interval.is_certain) return std::nullopt;
    for (const DistanceSieve::Open& other : open) {
        const bool is_same = other.interval.is_certain && other.interval.b == best->interval.b;
        if (!is_same && key_of(other.interval.lower) <= key_of(best->interval.upper)) return std::nullopt;
    }
    const std::uint32_t triangle = best->triangles.b;
    const Feature feature = feature_of(best->interval.b, triangle, body_.mesh().triangles()[triangle]);
    return OnlyFeature{feature, feature.kind == Feature::Kind::face ? working_.pair.side_of_face(best->triangles) : 0};
}

}  // namespace ecods
