// Defines the memory that a QueryMemory holds for each kind of query.
#pragma once

#include <memory>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/intersection.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods {

// The memory of queries of another folder, created on first use.
struct QueryMemoryPart {
    virtual ~QueryMemoryPart() = default;
};

struct QueryMemory::State {
    TriangleRelations pair;
    SeparatingAxes axes;
    std::vector<NodePair> stack;
    QueryCounts counts;
    std::unique_ptr<QueryMemoryPart> distance, hit, cast, moving, solid, convex, depth, certificate;
};

struct QueryMemoryAccess {
    using State = QueryMemory::State;
    static State& state(QueryMemory& memory) noexcept { return *memory.state_; }

    // The memory of one kind of query, which `place` points to; created on first use.
    template <class Part>
    static Part& part(QueryMemory& memory, std::unique_ptr<QueryMemoryPart> State::*place) {
        auto& part = state(memory).*place;
        if (!part) part = std::make_unique<Part>();
        return static_cast<Part&>(*part);
    }
};

// Makes a query within another one: its work is counted, but not as another query.
template <class Function>
auto as_part(QueryMemory& memory, Function&& ask) {
    struct NotCounted {
        QueryCounts& counts;
        std::uint64_t queries = counts.queries;
        ~NotCounted() { counts.queries = queries; }
    };
    const NotCounted restore{QueryMemoryAccess::state(memory).counts};
    return ask();
}

}  // namespace ecods
