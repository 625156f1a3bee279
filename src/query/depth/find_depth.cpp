#include "base/double_key.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/depth/depth_memory.hpp"

namespace ecods::depths {

ConvexPair pair_of(convex::PosedHulls& hulls) {
    return {ConvexBody{&hulls.hull(0), hulls.body(0)}, ConvexBody{&hulls.hull(1), hulls.body(1)}};
}

std::optional<ExactDepth> find_depth(convex::PosedHulls& hulls, DepthMemory& memory) {
    const ConvexPair pair = pair_of(hulls);
    if (const std::optional<ExactDepth> flat = depth_in_plane(pair))
        return convex::find_closest(hulls, nullptr) ? std::nullopt : flat;
    switch (memory.polytope.find(hulls)) {
        case InnerPolytope::End::apart:
            return std::nullopt;
        case InnerPolytope::End::nearest:
            if (const auto shown = memory.planes.find(pair, hulls, memory.polytope)) return *shown;
            [[fallthrough]];
        default:
            return exact_depth(pair);
    }
}

Depth depth_of(convex::PosedHulls& hulls, const ExactDepth& found) {
    return {found.depth, name_of(hulls.hull(0), found.face[0]), name_of(hulls.hull(1), found.face[1]), found.direction};
}

convex::LeastDifference least_of(convex::PosedHulls& hulls, const ExactDepth& found) {
    return convex::least_of_deepest(hulls, found.face, found.direction, key_of(found.depth) == 0);
}

}  // namespace ecods::depths
