// What must hold of a world after an update, as functions that can be called on any world. Each throws CheckFailed.
//
// They ask the world through its public functions and trust none of its answers. What is expected comes from the oracle
// (truth.hpp), from the world's own boxes compared all with all, or from a second world.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ecods/trace.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/checks/truth.hpp"

namespace ecods::fuzz {

// The first half of completeness: the box of each body that changed contains its exact points.
void check_boxes(const World& world, const Truth& truth, Counters& counters);

// The second half: candidate pairs are those of all pairs over the stored boxes that are not filtered out, and what
// statistics() counts is what is there.
void check_candidates(World& world, Counters& counters);

// Questions about pairs of which a body changed: relation, boolean and list of triangles are the oracle's, in both
// orders.
void check_answers(World& world, const Truth& truth, Counters& counters);

// Queries with what is no body, here with a copy of a body and with its box.
void check_queries(World& world, const Truth& truth, BodyId body, Counters& counters);

// The colliding pairs are the oracle's that are not filtered out. Pairs of bodies that it does not know are passed
// over.
void check_collisions(const World& world, const std::vector<BodyPair>& expected, const Truth& truth);
std::vector<BodyPair> true_collisions(const World& world, const Truth& truth);

// The events lead from the collisions that were before to those that are.
void check_events(const World& world, const std::vector<BodyPair>& before);

// Some of the pairs that are within the clearance, or nearly, are in the list if the oracle says so, and no other is;
// the events lead from the close pairs that were before to those that are. `seed` chooses.
void check_close_pairs(const World& world, const std::vector<BodyPair>& before, const Truth& truth, std::uint32_t seed,
                       Counters& counters);

// The nearest of a body, of a copy of it, and of all pairs, is the least that is found by asking all.
void check_nearest(World& world, BodyId body, Counters& counters);

// World::check_invariants(): every invariant, and each verdict that was kept is that of a fresh test.
void check_invariants(const World& world);

// A fresh world, its bodies in the order that `order` stands for, has the same digest, the same collisions and as
// many candidates; but for the last, it may be called in another floating-point environment. `set_up` registers the
// tests of the caller's own shapes.
struct FreshWorld {
    WorldOptions options = {};
    std::uint32_t order = 0;
    bool has_own_environment = false;
    std::function<void(World&)> set_up = [](World&) {};
};
void check_fresh_world(const World& world, const FreshWorld& fresh);

// Two worlds that were given the same calls are the same: lists, boxes, digest, and counts of work (not of the broad
// phase's).
void check_same(World& world, World& other, Counters& counters);

// A trace that begins now, over an update at which nothing has moved, runs again without a difference.
void check_trace(World& world, const TraceOptions& writing, const ReplayOptions& reading);

}  // namespace ecods::fuzz
