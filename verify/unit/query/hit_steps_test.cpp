// A segment that goes on its way in small steps: the answers are those of a memory that has seen none of them, in
// whatever pose, and most steps are answered without a walk.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "ecods/hit.hpp"
#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "judge/hit_truth.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

// Steps among some points, on the way to one after the other: from each point to the next, or of a needle that is
// moved.
std::vector<Segment> steps_among(const std::vector<Vec3>& stations, int per_station, bool is_path) {
    std::vector<Segment> steps;
    const Vec3 needle = 0.25 * (stations[1] - stations[0]);
    Vec3 at = stations[0];
    for (std::size_t i = 1; i < stations.size(); ++i) {
        const Vec3 from = stations[i - 1], by = (stations[i] - from) / per_station;
        for (int k = 1; k <= per_station; ++k) {
            const Vec3 next = k == per_station ? stations[i] : Vec3(from + k * by);
            steps.push_back({at, is_path ? next : Vec3(at + needle)});
            at = next;
        }
    }
    return steps;
}

struct Work {
    std::uint64_t hits = 0, boxes = 0, steps = 0, steps_without_boxes = 0;
};

Work expect_same(const std::vector<Segment>& steps, const Posed<MeshShape>& body) {
    Work work;
    QueryMemory memory;
    PairWitness witness;
    for (const Segment& step : steps) {
        QueryMemory fresh;
        const std::uint64_t before = memory.counts().box_tests;
        const std::optional<Hit> hit = first_hit(step, body, {memory, witness}),
                                 expected = first_hit(step, body, fresh);
        EXPECT_EQ(hit.has_value(), expected.has_value());
        EXPECT_TRUE(!hit || !expected || judge::is_same(*hit, *expected)) << judge::text(*hit);
        const std::uint64_t boxes = memory.counts().box_tests - before;
        work.hits += expected.has_value();
        work.boxes += boxes;
        work.steps_without_boxes += boxes == 0 && fresh.counts().box_tests > 0;
        ++work.steps;
    }
    return work;
}

// Stations are vertices, so that steps end on the surface and pass through its vertices, and points beside it.
std::vector<Vec3> stations_of(const Mesh& mesh, const Pose& pose, scenes::Random& random) {
    std::vector<Vec3> stations;
    std::uint32_t vertex = random.below(static_cast<std::uint32_t>(mesh.vertices().size()));
    for (int i = 0; i < 12; ++i) {
        const Vec3 at = pose.R * mesh.vertices()[vertex] + pose.t;
        const Vec3 beside = 0.05 * (pose.R * random.direction());
        stations.push_back(i % 3 == 0 ? at : Vec3(at + beside));
        vertex = (vertex + 1 + random.below(3)) % static_cast<std::uint32_t>(mesh.vertices().size());
    }
    return stations;
}

std::vector<Pose> poses(scenes::Random& random) {
    const Mat3 rotation = random.rotation().toRotationMatrix();
    Mat3 sheared = rotation, flat = rotation, mirrored = Mat3::Identity();
    sheared(0, 1) += 0.75;
    flat.row(2) = flat.row(0);
    mirrored(1, 1) = -1;
    return {{},
            {rotation, Vec3(0.5, -3, 2)},
            {mirrored, Vec3(1, 2, 3)},
            {sheared, Vec3(1, 2, 3)},
            {flat, Vec3(1, 2, 3)},
            {rotation * 0x1p-500, Vec3(1, -1, 1) * 0x1p-500},
            {rotation * 0x1p-1060, Vec3(1, -1, 1) * 0x1p-1060},
            {rotation * 0x1p900, Vec3(1, -1, 1) * 0x1p900},
            {rotation, Vec3(1e6, -1e6, 1e6)},
            {rotation, Vec3(1e15, -1e15, 1e15)}};
}

TEST(HitSteps, AnswersAreThoseOfAMemoryThatHasSeenNone) {
    scenes::Random random(5);
    const MeshShape shape(scenes::torus(60, 30, 0.4));
    for (int round = 0; round < 2; ++round) {
        for (const Pose& pose : poses(random)) {
            const std::vector<Vec3> stations = stations_of(shape.mesh(), pose, random);
            for (const bool is_path : {true, false}) {
                expect_same(steps_among(stations, 16, is_path), {shape, pose});
            }
        }
    }
}

TEST(HitSteps, MostNeedNoWalk) {
    scenes::Random random(6);
    const MeshShape shape(scenes::torus(200, 100, 0.4));
    const Pose pose{random.rotation().toRotationMatrix(), Vec3(0.5, -3, 2)};
    Work work;
    for (int round = 0; round < 10; ++round) {
        const Work one = expect_same(steps_among(stations_of(shape.mesh(), pose, random), 40, true), {shape, pose});
        work.steps += one.steps;
        work.steps_without_boxes += one.steps_without_boxes;
        work.hits += one.hits;
    }
    EXPECT_GT(work.hits, work.steps / 100);
    EXPECT_GT(work.steps_without_boxes, work.steps / 2);
}

// What was gathered for one body, or one pose of it, is not taken for another.
TEST(HitSteps, OfBodiesInTurn) {
    scenes::Random random(7);
    const MeshShape torus(scenes::torus(60, 30, 0.4)), sphere(scenes::sphere(40, 20));
    const Pose pose{random.rotation().toRotationMatrix(), Vec3(0.5, -3, 2)};
    Pose other = pose;
    other.t[1] = std::nextafter(other.t[1], 0);
    const std::vector<Segment> steps = steps_among(stations_of(torus.mesh(), pose, random), 24, true);
    QueryMemory memory;
    PairWitness witness;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Posed<MeshShape> body{i / 5 % 3 == 2 ? sphere : torus, i / 5 % 3 == 1 ? other : pose};
        QueryMemory fresh;
        const std::optional<Hit> hit = first_hit(steps[i], body, {memory, witness}),
                                 expected = first_hit(steps[i], body, fresh);
        ASSERT_EQ(hit.has_value(), expected.has_value());
        EXPECT_TRUE(!hit || judge::is_same(*hit, *expected));
        if (i % 7 == 0) std::ignore = all_hits(steps[i], body, memory);
    }
}

TEST(HitSteps, InEveryEnvironment) {
    const MeshShape shape(scenes::torus(60, 30, 0.4));
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        for (const environment::FloatMode& mode : environment::float_modes) {
            scenes::Random random(8);
            const Pose pose{random.rotation().toRotationMatrix(), Vec3(0.5, -3, 2)};
            const std::vector<Segment> steps = steps_among(stations_of(shape.mesh(), pose, random), 24, true);
            const environment::InFloatMode in_mode(mode);
            expect_same(steps, {shape, pose});
        }
    }
}

}  // namespace
}  // namespace ecods
