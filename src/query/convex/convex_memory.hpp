// ConvexMemory is the scratch memory of the questions about two convex solids.
#pragma once

#include "exact/point/integer_frame.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods::convex {

struct ConvexMemory final : QueryMemoryPart {
    exact::IntegerFrame points;

    static ConvexMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<ConvexMemory>(memory, &QueryMemoryAccess::State::convex);
    }
};

}  // namespace ecods::convex
