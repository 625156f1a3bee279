// What a QueryMemory holds: the memory of each question.
#pragma once

#include <memory>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/intersection.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods {

// The memory of a question of another folder, made when that is asked first.
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

    // What a question keeps, which is at `place`; made when it is asked first.
    template <class Part>
    static Part& part(QueryMemory& memory, std::unique_ptr<QueryMemoryPart> State::*place) {
        auto& part = state(memory).*place;
        if (!part) part = std::make_unique<Part>();
        return static_cast<Part&>(*part);
    }
};

// Asks a question that is a part of another one: what it does is counted, and the question is not.
template <class Ask>
auto as_part(QueryMemory& memory, Ask&& ask) {
    struct NotCounted {
        QueryCounts& counts;
        std::uint64_t queries = counts.queries;
        ~NotCounted() { counts.queries = queries; }
    };
    const NotCounted restore{QueryMemoryAccess::state(memory).counts};
    return ask();
}

}  // namespace ecods
