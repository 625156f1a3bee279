#include "ecods/solid.hpp"

#include <optional>

#include "query/convex/posed_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {

std::optional<Depth> depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    convex::PosedHulls hulls(a, b, memory);
    const std::optional<depths::ExactDepth> found = depths::find_depth(hulls, depths::DepthMemory::of(memory));
    if (!found) return std::nullopt;
    const Depth result = depth_of(hulls, *found);
    asking.witness() = {result.a.triangle, result.b.triangle};
    return result;
}

}  // namespace ecods
