// OneTimeMemory is scratch memory of casts in which each body is compared, at each time, with a straight motion at the
// same time.
#pragma once

#include "query/cast/both_turning_question.hpp"
#include "query/cast/turn_and_straight_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/search/search.hpp"

namespace ecods {

struct OneTimeMemory : QueryMemoryPart {
    static OneTimeMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<OneTimeMemory>(memory, &QueryMemoryAccess::State::both_turning);
    }

    SearchMemory<BothTurningQuestion> both_turn;
    SearchMemory<TurnAndStraightQuestion> turn_and_straight;
};

}  // namespace ecods
