// The depth of two convex solids with its two points, and along a direction.
#include <optional>

#include "base/double_key.hpp"
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
    DepthPoints result;
    result.depth = {found->depth, name_of(hulls.hull(0), found->face[0]), name_of(hulls.hull(1), found->face[1]),
                    found->direction};
    result.a = at.a;
    result.b = at.b;
    result.point_a = at.point_a;
    result.point_b = at.point_b;
    asking.witness() = {result.depth.a.triangle, result.depth.b.triangle};
    return result;
}

std::optional<DepthAlong> depth_along(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Vec3& direction,
                                      const Ask& ask) {
    validate_motion(direction);
    if (key_of(direction[0]) == 0 && key_of(direction[1]) == 0 && key_of(direction[2]) == 0) {
        throw InvalidArgument("the direction of a depth must not be zero", Argument::motion);
    }
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    convex::PosedHulls hulls(a, b, memory);
    const depths::ConvexPair pair{depths::ConvexBody{&hulls.hull(0), hulls.body(0)},
                                  depths::ConvexBody{&hulls.hull(1), hulls.body(1)}};
    if (const auto flat = depths::depth_in_plane(pair)) {
        if (convex::find_closest(hulls, nullptr)) return std::nullopt;
        return DepthAlong{0, 0, name_of(hulls.hull(0), flat->face[0]), name_of(hulls.hull(1), flat->face[1]),
                          flat->direction};
    }
    const auto found = depths::exact_depth_along(pair, direction);
    if (!found) return std::nullopt;
    return DepthAlong{found->parameter, found->length, name_of(hulls.hull(0), found->face[0]),
                      name_of(hulls.hull(1), found->face[1]), found->normal};
}

}  // namespace ecods
