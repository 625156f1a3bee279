// Visits the boxes near a box, the pairs of boxes near each other, and the boxes that a segment, a ray or a moving box
// may meet, best first.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/limits.hpp"
#include "base/make_error.hpp"
#include "broad_phase/boxes/along_walk.hpp"
#include "broad_phase/boxes/near_walk.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "ecods/pose.hpp"
#include "geometry/box_distance.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

// Visits boxes as the tree walks do, without trees: the boxes whose lower bound lower_of(box) is at most
// greatest(limit), in ascending order of that bound. greatest(x) is the greatest lower bound that a limit x admits.
// Each visit returns a new limit, which counts if it is smaller. Returns the number of box tests.
template <class LowerOf, class Greatest>
std::uint64_t scan(const ProxyTable& table, double limit, const LowerOf& lower_of, const Greatest& greatest,
                   const std::function<double(ProxyIndex)>& visit) {
    std::vector<std::pair<double, ProxyIndex>> found;
    limit = greatest(limit);
    table.for_each([&](ProxyIndex proxy, const Aabb& box) {
        const double lower = lower_of(box);
        if (lower <= limit) found.emplace_back(lower, proxy);
    });
    std::sort(found.begin(), found.end());
    for (const auto& [lower, proxy] : found) {
        if (lower > limit) break;
        limit = std::min(limit, greatest(visit(proxy)));
    }
    return table.size();
}

// Visits near pairs in the order of proxies: sorting by distance would take memory for all pairs.
std::uint64_t scan_near_pairs(const ProxyTable& table, double limit, const std::function<double(ProxyPair)>& visit) {
    std::uint64_t tests = 0;
    table.for_each([&](ProxyIndex a, const Aabb& box) {
        for (ProxyIndex b = a + 1; b < table.end(); ++b) {
            if (!table.is_present(b)) continue;
            ++tests;
            if (distance_below(box, table.boxes()[b]) <= limit) limit = std::min(limit, visit({a, b}));
        }
    });
    return tests;
}

}  // namespace

void OverlapTracker::visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(box);
    require_distance(limit);
    const auto lower_of = [&](const Aabb& other) { return distance_below(box, other); };
    const auto greatest = [](double any_limit) { return any_limit; };
    count_find(has_near_trees() ? walk_near(current_index().trees(), table_.boxes(), box, limit, visit)
                                : scan(table_, limit, lower_of, greatest, visit));
}

void OverlapTracker::visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const {
    require_distance(limit);
    const auto visit_slots = [&](SlotIndex a, SlotIndex b) { return visit({a, b}); };
    count_find(has_near_trees() ? walk_near_pairs(current_index().trees(), table_.boxes(), limit, visit_slots)
                                : scan_near_pairs(table_, limit, visit));
}

void OverlapTracker::visit_along(const MovingBox& moving, double limit,
                                 const std::function<double(ProxyIndex)>& visit) const {
    const auto lower_of = [&](const Aabb& box) { return moving.meets_from(box); };
    // Caps the limit at number_max, since a box that is never met has an infinite time and must not be visited.
    const auto greatest = [](double time) { return std::min(MovingBox::latest(time), MovingBox::number_max); };
    count_find(has_near_trees() ? walk_along(current_index().trees(), table_.boxes(), moving, limit, visit)
                                : scan(table_, limit, lower_of, greatest, visit));
}

void OverlapTracker::visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(segment);
    visit_along(MovingBox(segment), 1, visit);
}

void OverlapTracker::visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(ray);
    visit_along(MovingBox(ray), ray.max_parameter, visit);
}

void OverlapTracker::visit_along(const Aabb& box, const Vec3& motion, double limit,
                                 const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(box);
    validate_motion(motion);
    if (!is_from_zero(limit)) throw invalid_time(limit);
    visit_along(MovingBox(box, motion), limit, visit);
}

}  // namespace ecods
