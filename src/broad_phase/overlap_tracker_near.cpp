// Which boxes are near a box, and which are near each other.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/limits.hpp"
#include "broad_phase/boxes/near_walk.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "geometry/box_distance.hpp"

namespace ecods {
std::uint64_t OverlapTracker::scan_near(const Aabb& box, double limit,
                                        const std::function<double(ProxyIndex)>& visit) const {
    std::vector<std::pair<double, ProxyIndex>> near;
    for (ProxyIndex proxy = 0; proxy < table_.end(); ++proxy) {
        if (!table_.is_present(proxy)) continue;
        const double lower = distance_below(box, table_.boxes()[proxy]);
        if (lower <= limit) near.emplace_back(lower, proxy);
    }
    std::sort(near.begin(), near.end());
    for (const auto& [lower, proxy] : near) {
        if (lower > limit) break;
        limit = std::min(limit, visit(proxy));
    }
    return table_.size();
}

// In the order of the pairs: sorting them by distance would take memory for all.
std::uint64_t OverlapTracker::scan_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const {
    const std::vector<Aabb>& boxes = table_.boxes();
    std::uint64_t tests = 0;
    for (ProxyIndex a = 0; a < table_.end(); ++a) {
        for (ProxyIndex b = a + 1; table_.is_present(a) && b < table_.end(); ++b) {
            if (!table_.is_present(b)) continue;
            ++tests;
            if (distance_below(boxes[a], boxes[b]) <= limit) limit = std::min(limit, visit({a, b}));
        }
    }
    return tests;
}

void OverlapTracker::visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(axis, box.min[axis], box.max[axis]);
    }
    require_distance(limit);
    count_find(has_near_trees() ? walk_near(current_index().trees(), table_.boxes(), box, limit, visit)
                                : scan_near(box, limit, visit));
}

void OverlapTracker::visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const {
    require_distance(limit);
    const auto visit_slots = [&](SlotIndex a, SlotIndex b) { return visit({a, b}); };
    count_find(has_near_trees() ? walk_near_pairs(current_index().trees(), table_.boxes(), limit, visit_slots)
                                : scan_near_pairs(limit, visit));
}

}  // namespace ecods
