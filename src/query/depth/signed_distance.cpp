#include <optional>

#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/depth/signed_pair.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace {

// Returns the signed distance of two solids that are apart if fixed precision decides all roundings; otherwise nullopt.
std::optional<SignedDistance> find_apart(const convex::PosedHulls& hulls, const convex::ClosestHulls& closest,
                                         const exact::Radii& radii) {
    const auto fixed = convex::find_fixed(hulls, closest, radii);
    const auto at = fixed ? fixed->signed_closest() : std::nullopt;
    const auto direction = at ? fixed->direction() : std::nullopt;
    if (!direction) return std::nullopt;
    return SignedDistance{at->distance, at->kind, at->a, at->b, at->point_a, at->point_b, *direction};
}

// Returns the signed distance of two solids that share a point: minus their depth and the radii.
SignedDistance deepest(convex::PosedHulls& hulls, const exact::Radii& radii, Asking& asking) {
    const std::optional<depths::ExactDepth> found = depths::find_depth(hulls, depths::DepthMemory::of(asking.memory()));
    ECODS_ASSERT(found);
    const ClosestPoints at = convex::name_deepest(hulls, depths::least_of(hulls, *found), radii);
    asking.witness() = {at.a.triangle, at.b.triangle};
    return {opposite(at.distance), at.kind, at.a, at.b, at.point_a, at.point_b, found->direction};
}

}  // namespace

SignedDistance signed_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Ask& ask) {
    return depths::signed_distance(a, b, {}, ask);
}

// Searches for the distance of the solids first, which is the result if the solids are apart; if they share a point,
// this search costs little.
SignedDistance depths::signed_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                       const exact::Radii& radii, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    const exact::ExactSum margin = radii.sum();
    convex::PosedHulls hulls(a, b, memory);
    if (const auto closest = convex::find_closest(hulls, &asking.witness())) {
        if (const auto apart = find_apart(hulls, *closest, radii)) return *apart;
        const ClosestPoints at = convex::name_closest(hulls, *closest, radii);
        const double distance = margin.sign() == 0
                                    ? at.distance
                                    : exact::round_signed_beyond(convex::square_of(hulls, closest->found), margin);
        return {distance, at.kind, at.a, at.b, at.point_a, at.point_b, convex::round_direction(hulls, closest->found)};
    }
    return deepest(hulls, radii, asking);
}

std::optional<SignedDistance> depths::signed_depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                   const exact::Radii& radii, const Ask& ask) {
    Asking asking(ask);
    ++QueryMemoryAccess::state(asking.memory()).counts.queries;
    convex::PosedHulls hulls(a, b, asking.memory());
    if (convex::find_closest(hulls, &asking.witness())) return std::nullopt;
    return deepest(hulls, radii, asking);
}

}  // namespace ecods
