#include "query/depth/depth_memory.hpp"

namespace ecods::depths {

std::optional<ExactDepth> find_depth(convex::PosedHulls& hulls, DepthMemory& memory) {
    const ConvexPair pair{ConvexBody{&hulls.hull(0), hulls.body(0)}, ConvexBody{&hulls.hull(1), hulls.body(1)}};
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

}  // namespace ecods::depths
