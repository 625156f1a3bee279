// A pair of bodies about which each question is asked, out of memory at any point.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "allocation/each_allocation.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/shapes.hpp"
#include "unit/allocation/answer_digest.hpp"

namespace ecods::allocation {

// Two spheres of a size at which queries use all their memory, with trees that nobody has made yet.
struct Pair {
    explicit Pair(double distance) { pose_b.t[0] = distance; }

    Posed<MeshShape> first() const { return {*a, pose_a}; }
    Posed<MeshShape> second() const { return {*b, pose_b}; }

    std::shared_ptr<const MeshShape> a = std::make_shared<MeshShape>(scenes::sphere(12, 8));
    std::shared_ptr<const MeshShape> b = std::make_shared<MeshShape>(scenes::torus(12, 8, 0.25));
    Pose pose_a, pose_b;
    QueryMemory memory;
    PairWitness witness;
    std::uint64_t answer = 0;
};

inline std::uint64_t digest_depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, Pair& p) {
    const std::optional<Depth> found = depth(a, b, {p.memory, p.witness});
    if (!found) return 1;
    return digest(found->depth) + digest(found->direction) + digest(found->a.triangle) + digest(found->b.triangle);
}

struct PairCall {
    const char* name;
    void (*ask)(Pair&);
};

inline void go_on(Pair& p) {
    Digest all(p.answer);
    for (int step = 0; step < 3; ++step) {
        p.pose_b.t[0] += 0.125;
        all.add(intersects(p.first(), p.second(), {p.memory, p.witness}));
        all.add(relation(p.second(), p.first(), p.memory));
        all.add(intersecting_triangles(p.first(), p.second(), p.memory).size());
        all.add(distance(p.first(), p.second(), {p.memory, p.witness}));
    }
    p.answer = all.value();
}

inline std::string difference(const Pair& expected, const Pair& got) {
    return expected.answer == got.answer ? "" : std::to_string(got.answer) + " for " + std::to_string(expected.answer);
}

inline Trial<Pair> trial_of(const PairCall& question, double distance) {
    return {.make = [=] { return Pair(distance); }, .call = question.ask, .difference = difference, .go_on = go_on};
}

}  // namespace ecods::allocation
