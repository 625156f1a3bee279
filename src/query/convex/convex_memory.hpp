// Scratch memory of the questions about two convex solids.
#pragma once

#include <memory>

#include "exact/point/integer_frame.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods::convex {

struct ConvexMemory final : QueryMemoryPart {
    exact::IntegerFrame points;

    static ConvexMemory& of(QueryMemory& memory) {
        auto& part = QueryMemoryAccess::state(memory).convex;
        if (!part) part = std::make_unique<ConvexMemory>();
        return static_cast<ConvexMemory&>(*part);
    }
};

}  // namespace ecods::convex
