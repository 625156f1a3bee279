#include "query/cast/way_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/next.hpp"
#include "query/cast/turn_leg.hpp"
#include "query/cast/turning_body.hpp"

namespace ecods {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pivot_max = 0x1p1000;

// Returns true if all coordinates of v are below the limit. Compares them one by one, because a NaN is below no limit.
bool is_below_max(const Vec3& v) {
    return std::abs(v[0]) < pivot_max && std::abs(v[1]) < pivot_max && std::abs(v[2]) < pivot_max;
}

}  // namespace

WayBoxes::WayBoxes(const Aabb& start, std::span<const WayNode> nodes) : nodes_(nodes) {
    const Vec3& pivot = nodes[0].pivot;
    const bool is_bounded = is_below_max(start.min) && is_below_max(start.max) && is_below_max(pivot);
    const Vec3 farthest = (start.min - pivot).cwiseAbs().cwiseMax((start.max - pivot).cwiseAbs());
    radius_ = is_bounded ? length_above(farthest) * (1 + 2 * two_u) + 0x1p-500 : infinite;
}

Aabb WayBoxes::of(std::size_t leg) const {
    const Vec3 &from = nodes_[leg].pivot, &to = nodes_[leg + 1].pivot;
    Aabb box{Vec3::Constant(-infinite), Vec3::Constant(infinite)};
    if (!(radius_ < infinite) || !is_below_max(from) || !is_below_max(to)) return box;
    for (int k = 0; k < 3; ++k) {
        box.min[k] = next_down(std::min(from[k], to[k]) - radius_);
        box.max[k] = next_up(std::max(from[k], to[k]) + radius_);
    }
    return box;
}

Aabb WayBoxes::whole() const {
    Aabb box = of(0);
    for (std::size_t leg = 1; leg <= last_leg(nodes_); ++leg) {
        const Aabb next = of(leg);
        box = {box.min.cwiseMin(next.min), box.max.cwiseMax(next.max)};
    }
    return box;
}

double WayBoxes::before(std::size_t leg) const noexcept {
    return leg == 0 ? -1 : next_down(static_cast<double>(leg) / static_cast<double>(last_leg(nodes_) + 1));
}

}  // namespace ecods
