// Defines the parts of a QueryMemory, one for each kind of query.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/intersection.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods {

// QueryMemoryPart is the base of the parts that other folders define. A part is created on first use.
struct QueryMemoryPart {
    virtual ~QueryMemoryPart() = default;
};

struct QueryMemory::State {
    TriangleRelations pair;
    SeparatingAxes axes;
    std::vector<NodePair> stack;
    QueryCounts counts;
    std::unique_ptr<QueryMemoryPart> distance, point, hit, cast, moving, solid, convex, depth, half_space, certificate,
        closest_pairs, turning, both_turning;
};

struct QueryMemoryAccess {
    using State = QueryMemory::State;
    static State& state(QueryMemory& memory) noexcept { return *memory.state_; }

    // Returns the part to which the member `place` of the state points; creates it on first use.
    template <class Part>
    static Part& part(QueryMemory& memory, std::unique_ptr<QueryMemoryPart> State::*place) {
        auto& part = state(memory).*place;
        if (!part) part = std::make_unique<Part>();
        return static_cast<Part&>(*part);
    }
};

// Calls ask(), a query within another query. The work of ask() is counted, but not as a query of its own.
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

// Calls ask(), which makes several queries, and counts them as one query.
template <class Function>
auto as_one_query(QueryMemory& memory, Function&& ask) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    return as_part(memory, std::forward<Function>(ask));
}

}  // namespace ecods
