// This file implements depth_points() and depth_along(): the depth of two overlapping convex solids with the deepest
// points, and their depth along a direction.
#include <optional>

#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/depth/exact_depth_along.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

std::optional<DepthPoints> depth_points(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    convex::PosedHulls hulls(a, b, memory);
    const std::optional<depths::ExactDepth> found = depths::find_depth(hulls, depths::DepthMemory::of(memory));
    if (!found) return std::nullopt;
    const ClosestPoints at = convex::name_deepest(hulls, least_of(hulls, *found));
    const DepthPoints result{depth_of(hulls, *found), at.a, at.b, at.point_a, at.point_b};
    asking.witness() = {result.depth.a.triangle, result.depth.b.triangle};
    return result;
}

std::optional<DepthAlong> depth_along(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Vec3& direction,
                                      const Ask& ask) {
    validate_motion(direction);
    if (is_zero(direction)) throw InvalidArgument("the direction of a depth must not be zero", Argument::motion);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    convex::PosedHulls hulls(a, b, memory);
    const depths::ConvexPair pair = depths::pair_of(hulls);
    const auto answer = [&](double parameter, double length, const depths::DifferenceFace& face, const Vec3& normal) {
        return DepthAlong{parameter, length, name_of(hulls.hull(0), face[0]), name_of(hulls.hull(1), face[1]), normal};
    };
    if (const auto flat = depths::depth_in_plane(pair)) {
        if (convex::find_closest(hulls, nullptr)) return std::nullopt;
        return answer(0, 0, flat->face, flat->direction);
    }
    const auto found = depths::exact_depth_along(pair, direction);
    if (!found) return std::nullopt;
    return answer(found->parameter, found->length, found->face, found->normal);
}

}  // namespace ecods
