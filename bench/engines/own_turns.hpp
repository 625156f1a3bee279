// The first contacts of a workload of turns, by ECoDS; and of the straight motions to the same ends.
#pragma once

#include <optional>

#include "ecods/cast.hpp"
#include "ecods/turn.hpp"
#include "engines/own_shapes.hpp"
#include "scenes/turn_workloads.hpp"

namespace ecods::bench {

class OwnTurns {
  public:
    explicit OwnTurns(const scenes::TurnWorkload& workload) : posed_(workload.meshes) {}

    Turning<MeshShape> turning(const scenes::TurnQuery& query) const {
        return {posed_.at(query.a.mesh_index), query.a.pose, query.turn};
    }
    Posed<MeshShape> resting(const scenes::TurnQuery& query) const { return posed_(query.b); }

    std::optional<FirstContact> turn(const scenes::TurnQuery& query, QueryCounts* counts = nullptr) {
        return cast(turning(query), resting(query), 1, ask(counts));
    }
    std::optional<FirstContact> go_straight(const scenes::TurnQuery& query, QueryCounts* counts = nullptr) {
        return cast(Moving<MeshShape>(posed_.at(query.a.mesh_index), query.a.pose, query.a_end),
                    Moving<MeshShape>(posed_.at(query.b.mesh_index), query.b.pose, query.b.pose), 1, ask(counts));
    }

  private:
    Ask ask(QueryCounts* counts) {
        Ask ask(memory_);
        ask.counts = counts;
        return ask;
    }

    OwnShapes<MeshShape> posed_;
    QueryMemory memory_;
};

}  // namespace ecods::bench
