#include "fuzz/check_frame.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "fuzz/failure.hpp"

namespace ecods::fuzz {
namespace {

std::string text(const BodyPair& pair) {
    return fmt::format("{}.{}-{}.{}", pair.a.slot, pair.a.generation, pair.b.slot, pair.b.generation);
}

std::string text(std::span<const BodyPair> pairs) {
    std::string result;
    for (const BodyPair& pair : pairs) result.append(" ").append(text(pair));
    return result;
}

void require_equal(std::span<const BodyPair> got, std::span<const BodyPair> expected, const char* check) {
    require(std::ranges::equal(got, expected), check, fmt::format("expected{}; got{}", text(expected), text(got)));
}

std::vector<BodyPair> only_in_first(const std::vector<BodyPair>& first, const std::vector<BodyPair>& second) {
    std::vector<BodyPair> result;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(result));
    return result;
}

// Calls `act` for all pairs of bodies, the smaller id first.
template <class Act>
void for_all_pairs(std::vector<Body>& bodies, Act act) {
    for (Body& a : bodies) {
        for (Body& b : bodies) {
            if (a.id < b.id) act(BodyPair{a.id, b.id}, a, b);
        }
    }
}

// The two halves of the broad phase: boxes contain the exact bodies, and pairs are those of all stored boxes.
void check_boxes(Scene& scene, Counters& counters) {
    const World& world = scene.worlds[0];
    for (Body& body : scene.bodies) {
        if (!body.exact) body.exact.emplace(body.mesh, body.pose);
        if (!body.is_changed) continue;
        ++counters["checked: box contains body"];
        require(oracle::box_contains(world.box(body.id), *body.exact), "box contains body",
                std::to_string(body.id.slot));
        require(scene.worlds[1].box(body.id) == world.box(body.id), "boxes of both worlds",
                std::to_string(body.id.slot));
    }
    std::vector<BodyPair> expected;
    for_all_pairs(scene.bodies, [&](const BodyPair& pair, const Body&, const Body&) {
        if (oracle::boxes_overlap(world.box(pair.a), world.box(pair.b))) expected.push_back(pair);
    });
    std::sort(expected.begin(), expected.end());
    for (World& each : scene.worlds) require_equal(each.overlapping_pairs(), expected, "overlapping pairs");
}

void check_pair(World& world, const BodyPair& pair, const oracle::Verdict& verdict) {
    const auto as_text = [&](auto what) { return text(pair) + fmt::format(": oracle {}", what); };
    const int relation = static_cast<int>(verdict.relation);
    require(world.relation(pair.a, pair.b) == verdict.relation, "relation", as_text(relation));
    require(world.relation(pair.b, pair.a) == verdict.relation, "relation, swapped", as_text(relation));
    require(world.intersects(pair.a, pair.b) == (relation != 0), "intersects", as_text(relation));
    std::vector<TrianglePair> expected = verdict.triangles;
    require(world.touching_triangles(pair.a, pair.b) == expected, "touching triangles", as_text(expected.size()));
    for (TrianglePair& triangles : expected) std::swap(triangles.a, triangles.b);
    std::sort(expected.begin(), expected.end());
    require(world.touching_triangles(pair.b, pair.a) == expected, "touching triangles, swapped",
            as_text(expected.size()));
}

// Pairs of which no body changed keep what the oracle said before: a world that lost a kept verdict is found.
void ask_oracle(Scene& scene, Counters& counters) {
    std::map<BodyPair, oracle::Verdict> verdicts;
    for_all_pairs(scene.bodies, [&](const BodyPair& pair, const Body& a, const Body& b) {
        const auto known = scene.verdicts.find(pair);
        if (!a.is_changed && !b.is_changed && known != scene.verdicts.end()) {
            verdicts[pair] = std::move(known->second);
            return;
        }
        const auto& verdict = verdicts[pair] = oracle::verdict(*a.exact, *b.exact);
        ++counters["checked: pair against the oracle"];
        counters["checked: triangle pairs that touch"] += verdict.triangles.size();
        ++counters[verdict.relation == Relation::disjoint   ? "pair disjoint"
                   : verdict.relation == Relation::touching ? "pair touching"
                                                            : "pair crossing"];
        for (World& world : scene.worlds) check_pair(world, pair, verdict);
    });
    scene.verdicts = std::move(verdicts);
}

void check_collisions(Scene& scene, const CheckOptions& options) {
    std::vector<BodyPair> colliding;
    for (const auto& [pair, verdict] : scene.verdicts) {
        if (verdict.relation != Relation::disjoint) colliding.push_back(pair);
    }
    if (options.canary && !colliding.empty()) colliding.erase(colliding.begin());
    const auto began = only_in_first(colliding, scene.colliding);
    const auto ended = only_in_first(scene.colliding, colliding);
    for (const World& world : scene.worlds) {
        require_equal(world.colliding_pairs(), colliding, "colliding pairs");
        require_equal(world.began(), began, "began");
        require_equal(world.ended(), ended, "ended");
    }
    scene.colliding = std::move(colliding);
}

void check_fresh_world(const Scene& scene, scenes::Random& random) {
    std::vector<const Body*> order;
    for (const Body& body : scene.bodies) order.push_back(&body);
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    }
    World fresh({.broad_phase = BroadPhaseKind::sweep_and_prune});
    for (const Body* body : order) fresh.create_body(body->mesh, body->pose);
    fresh.update();
    require(fresh.colliding_pairs().size() == scene.colliding.size(), "fresh world", "another number of collisions");
    for (const World& world : scene.worlds) {
        require(world.digest() == fresh.digest(), "fresh world", "another digest");
    }
}

}  // namespace

void check_frame(Scene& scene, const CheckOptions& options, scenes::Random& random, Counters& counters) {
    check_boxes(scene, counters);
    ask_oracle(scene, counters);
    check_collisions(scene, options);
    for (const World& world : scene.worlds) world.validate();
    check_fresh_world(scene, random);
    for (Body& body : scene.bodies) body.is_changed = false;
}

}  // namespace ecods::fuzz
