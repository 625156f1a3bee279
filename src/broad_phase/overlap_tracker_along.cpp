// Which boxes a segment, a ray or a box on the move may meet, the first ones first.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/double_key.hpp"
#include "broad_phase/boxes/along_walk.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "ecods/error.hpp"
#include "ecods/motion.hpp"

namespace ecods {
namespace {

// All boxes, as walk_along() visits them. Returns the number of box tests.
std::uint64_t scan_along(const ProxyTable& table, const MovingBox& moving, double limit,
                         const std::function<double(ProxyIndex)>& visit) {
    std::vector<std::pair<double, ProxyIndex>> met;
    limit = MovingBox::latest(limit);
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        if (!table.is_present(proxy)) continue;
        const double from = moving.meets_from(table.boxes()[proxy]);
        if (from <= limit && from <= MovingBox::number_max) met.emplace_back(from, proxy);
    }
    std::sort(met.begin(), met.end());
    for (const auto& [from, proxy] : met) {
        if (from > limit) break;
        limit = std::min(limit, MovingBox::latest(visit(proxy)));
    }
    return table.size();
}

}  // namespace

void OverlapTracker::visit_along(const MovingBox& moving, double limit,
                                 const std::function<double(ProxyIndex)>& visit) const {
    count_find(has_near_trees() ? walk_along(current_index().trees(), table_.boxes(), moving, limit, visit)
                                : scan_along(table_, moving, limit, visit));
}

void OverlapTracker::visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(segment);
    visit_along(MovingBox(segment), 1, visit);
}

void OverlapTracker::visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const {
    ecods::validate(ray);
    visit_along(MovingBox(ray), ray.parameter_max, visit);
}

void OverlapTracker::visit_along(const Aabb& box, const Vec3& motion, double limit,
                                 const std::function<double(ProxyIndex)>& visit) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(axis, box.min[axis], box.max[axis]);
    }
    validate_motion(motion);
    const std::int64_t key = key_of(limit);
    if (key < 0 || key > key_of(std::numeric_limits<double>::infinity())) throw InvalidTime(limit);
    visit_along(MovingBox(box, motion), limit, visit);
}

}  // namespace ecods
