#include "query/depth/depth_memory.hpp"

namespace ecods::depths {

std::optional<ExactDepth> find_depth(const ConvexPair& pair, const convex::PosedHulls& hulls, DepthMemory& memory) {
    if (!memory.hulls.bind(hulls)) return exact_depth(pair);
    const InnerPolytope::End end = memory.polytope.find(memory.hulls);
    if (end == InnerPolytope::End::apart) return std::nullopt;
    if (end == InnerPolytope::End::nearest) {
        const auto shown = memory.planes.find(pair, memory.hulls, memory.polytope, memory.points);
        if (shown) return *shown;
    }
    return exact_depth(pair);
}

}  // namespace ecods::depths
