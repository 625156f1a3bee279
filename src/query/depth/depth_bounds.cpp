#include <algorithm>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/depth/inner_balls.hpp"
#include "query/depth/parting_search.hpp"
#include "query/intersection/asking.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

const ConvexSolid* as_convex(const Posed<Solid>& solid) {
    return dynamic_cast<const ConvexSolid*>(solid.what);
}

// Returns the bounds for two solids of which at least one is flat. If one solid is not convex, the solids have no inner
// points in common, and the depth is 0. If both are convex, depth() computes the depth, and a translation along its
// direction parts the solids.
std::optional<DepthBounds> bounds_of_flat(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) {
    const ConvexSolid *convex_a = as_convex(a), *convex_b = as_convex(b);
    DepthBounds result{0, 0, b.pose.t};
    if (convex_a == nullptr || convex_b == nullptr) {
        return intersects(a, b, memory) ? std::optional(result) : std::nullopt;
    }
    const auto exact = depth({*convex_a, a.pose}, {*convex_b, b.pose}, memory);
    if (!exact) return std::nullopt;
    if (key_of(exact->depth) == 0) return result;
    depths::PartingSearch search(a, b, memory);
    search.try_length(exact->direction, exact->depth);
    return DepthBounds{std::max(0.0, next_down(exact->depth)), search.best().length, search.best().parted};
}

}  // namespace

std::optional<DepthBounds> depth_bounds(const Posed<Solid>& a, const Posed<Solid>& b, const Ask& ask) {
    if (!exact::is_regular(a.pose.R)) throw SingularPose(0);
    if (!exact::is_regular(b.pose.R)) throw SingularPose(1);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    if (!has_inside(*a.what) || !has_inside(*b.what)) return bounds_of_flat(a, b, memory);
    const Relation relation = solid_relation(a, b, memory);
    if (relation == Relation::apart) return std::nullopt;
    DepthBounds result{0, 0, b.pose.t};
    if (relation == Relation::touching) return result;

    depths::PartingSearch search(a, b, memory);
    const ConvexSolid *convex_a = as_convex(a), *convex_b = as_convex(b);
    const bool are_convex = convex_a != nullptr && convex_b != nullptr;
    if (are_convex) {
        const Depth exact = *depth({*convex_a, a.pose}, {*convex_b, b.pose}, memory);
        result.lower = std::max(0.0, next_down(exact.depth));
        search.try_length(exact.direction, exact.depth);
    }
    if (!search.has_found()) search.search();
    if (!are_convex) {
        std::optional<depths::BallHint> hint;
        if (search.best().middle) hint = {*search.best().middle, 0.25 * search.best().length};
        result.lower = depths::find_inner_balls(a, b, hint, memory);
    }
    result.upper = search.best().length;
    result.parted = search.best().parted;
    return result;
}

}  // namespace ecods
