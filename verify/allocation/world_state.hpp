// All that can be asked of a World without changing it, to see whether a call has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ecods/world.hpp"

namespace ecods::allocation {

struct BodyState {
    BodyId id;
    Pose pose;
    ShapeKind kind;
    std::uint64_t shape_digest;
    Aabb box;
    CollisionFilter filter;
    std::uint64_t user_data;

    friend bool operator==(const BodyState&, const BodyState&) = default;
};

struct WorldState {
    std::vector<BodyState> bodies;
    std::vector<BodyId> next_ids;  // up to the first one from which on all slots are new
    std::vector<BodyPair> disabled, overlapping, colliding, began, ended;
    std::optional<double> clearance;
    std::vector<BodyPair> close, close_began, close_ended;
    bool are_relations_listed;
    std::vector<PairRelation> relations;
    std::uint64_t digest;
    std::size_t overlapping_count, filtered_count;

    friend bool operator==(const WorldState&, const WorldState&) = default;
};

// Bodies, and lists as of the last update.
WorldState state_of(World& world);

// The first thing in which two states differ, for people; empty if in nothing.
std::string difference(const WorldState& expected, const WorldState& got);

}  // namespace ecods::allocation
