#include <optional>

#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "ecods/solid.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {

// Asks for the distance first: a search that fails costs least for solids that are apart, and little for others.
SignedDistance signed_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    convex::PosedHulls hulls(a, b, memory);
    if (const auto closest = convex::find_closest(hulls, &asking.witness())) {
        const ClosestPoints at = convex::name_closest(hulls, *closest);
        return {
            at.distance, at.kind, at.a, at.b, at.point_a, at.point_b, convex::round_direction(hulls, closest->found)};
    }
    const std::optional<depths::ExactDepth> found = depths::find_depth(hulls, depths::DepthMemory::of(memory));
    ECODS_ASSERT(found);
    const ClosestPoints at = convex::name_deepest(hulls, found->face, found->direction);
    asking.witness() = {at.a.triangle, at.b.triangle};
    return {opposite(at.distance), at.kind, at.a, at.b, at.point_a, at.point_b, found->direction};
}

}  // namespace ecods
