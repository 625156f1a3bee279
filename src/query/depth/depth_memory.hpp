// Scratch memory of depth().
#pragma once

#include <memory>

#include "query/depth/inner_polytope.hpp"
#include "query/depth/nearest_planes.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods::depths {

struct DepthMemory final : QueryMemoryPart {
    InnerPolytope polytope;
    NearestPlanes planes;

    static DepthMemory& of(QueryMemory& memory) {
        auto& part = QueryMemoryAccess::state(memory).depth;
        if (!part) part = std::make_unique<DepthMemory>();
        return static_cast<DepthMemory&>(*part);
    }
};

// The depth of two convex solids; nullopt if they share no point.
std::optional<ExactDepth> find_depth(convex::PosedHulls& hulls, DepthMemory& memory);

}  // namespace ecods::depths
