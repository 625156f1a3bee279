// DepthMemory is the scratch memory of depth().
#pragma once

#include "query/convex/closest_hulls.hpp"
#include "query/depth/inner_polytope.hpp"
#include "query/depth/nearest_planes.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods::depths {

struct DepthMemory final : QueryMemoryPart {
    InnerPolytope polytope;
    NearestPlanes planes;

    static DepthMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<DepthMemory>(memory, &QueryMemoryAccess::State::depth);
    }
};

ConvexPair pair_of(convex::PosedHulls& hulls);

// Returns the depth of two convex solids; nullopt if they share no point.
std::optional<ExactDepth> find_depth(convex::PosedHulls& hulls, DepthMemory& memory);

// Returns the Depth of the public interface: `found`, with the names of the features.
Depth depth_of(convex::PosedHulls& hulls, const ExactDepth& found);

// Returns the description of all pairs of points that the shortest separating translation brings together.
convex::LeastDifference least_of(convex::PosedHulls& hulls, const ExactDepth& found);

}  // namespace ecods::depths
