// What a World and its bodies are made with (world.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/collision_filter.hpp"
#include "ecods/executor.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

struct WorldOptions {
    BroadPhaseKind broad_phase = BroadPhaseKind::automatic;

    // Who runs the two-body tests of update(), depths() and solid_distances(); null: the thread that calls. Answers,
    // lists, events, digests and counts are the same for any executor and number of workers. Tests of the caller's own
    // are called by several threads, each with its own QueryMemory. Questions about a pair stay on the caller's thread.
    std::shared_ptr<Executor> executor = nullptr;

    // The ids that the first bodies get, in this order; later bodies get ids that no body had. World::bodies() and then
    // World::next_ids() of another world: so a copy of that world, or one that a program has stored, has each body
    // under the id that it had, refuses as stale each id that was stale, and goes on with the same ids. All ids are
    // then those of one world, so that neither of two such worlds knows the other's ids from its own. Empty: ids of a
    // new world.
    //
    // World() throws StaleBody, with the index of the entry, for a null id, for a second id of a slot, and for an id of
    // another world than the first one's. Memory: in proportion to the greatest slot.
    std::vector<BodyId> ids = {};
};

// A body to be. Either a mesh or a shape is needed.
struct BodyOptions {
    std::shared_ptr<const Mesh> mesh = nullptr;  // bodies given the same Mesh share its tree
    std::shared_ptr<const Shape> shape = nullptr;
    Pose pose = {};
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};

}  // namespace ecods
