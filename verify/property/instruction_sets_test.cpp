// A world is the same, frame for frame, with every instruction set: lists, boxes, digest and counts of work.
#include <gtest/gtest.h>

#include "ecods/world.hpp"
#include "environment/instruction_sets.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::test {
namespace {

constexpr int body_count = 250, frame_count = 12;

// What can be seen of a world after an update.
struct Frame {
    std::vector<BodyPair> overlapping, colliding, began, ended;
    std::vector<Aabb> boxes;
    std::vector<std::uint64_t> counts;
    std::uint64_t digest;

    friend bool operator==(const Frame&, const Frame&) = default;
};

std::vector<BodyPair> copy(std::span<const BodyPair> list) {
    return numbers_of(list);
}

Frame look_at(World& world) {
    Frame frame{copy(world.overlapping_pairs()),
                copy(world.colliding_pairs()),
                copy(world.began()),
                copy(world.ended()),
                {},
                {},
                world.digest()};
    for (const BodyId body : world.bodies()) frame.boxes.push_back(world.box(body));
    const Statistics s = world.statistics();
    frame.counts = {s.two_body_tests,
                    s.cache_hits,
                    s.broad_phase.box_tests,
                    s.broad_phase.candidates_filtered,
                    s.broad_phase.escaped,
                    s.broad_phase.rebuilds,
                    s.queries.box_tests,
                    s.queries.stages.triangle_tests,
                    s.queries.stages.filter_passes,
                    s.queries.stages.one_limb + s.queries.stages.two_limbs + s.queries.stages.many_limbs};
    return frame;
}

// Bodies that fly and turn through one another; the last few jump, and some come and go, so that everything that the
// broad phase does is done.
std::vector<Frame> run(BroadPhaseKind kind) {
    const std::shared_ptr<const Mesh> meshes[] = {scenes::cube(0.5), scenes::torus(24, 12, 0.4), scenes::ship()};
    scenes::Random random(7);
    World world({.broad_phase = kind});
    const auto anywhere = [&] {
        Pose pose = random.turned();
        for (int k = 0; k < 3; ++k) pose.t[k] = random.uniform(-5, 5);
        return pose;
    };
    std::vector<BodyId> bodies;
    for (int i = 0; i < body_count; ++i) bodies.push_back(world.create_body(meshes[i % 3], anywhere()));
    std::vector<Frame> frames;
    for (int frame = 0; frame < frame_count; ++frame) {
        world.update();
        frames.push_back(look_at(world));
        for (BodyId& body : bodies) {
            Pose pose = world.pose(body);
            pose.t += 0.2 * random.direction();
            world.set_pose(body, pose);
            if (random.below(50) == 0) world.set_pose(body, anywhere());
            if (random.below(50) != 0) continue;
            world.destroy_body(body);
            body = world.create_body(meshes[random.below(3)], anywhere());
        }
    }
    world.update();
    world.check_invariants();
    return frames;
}

class InstructionSets : public testing::TestWithParam<BroadPhaseKind> {};
INSTANTIATE_TEST_SUITE_P(BroadPhases, InstructionSets,
                         testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                         BroadPhaseKind::kept_candidates));

TEST_P(InstructionSets, GiveTheSameWorld) {
    const std::vector<Frame> widest = run(GetParam());
    std::size_t colliding = 0;
    for (const Frame& frame : widest) colliding += frame.colliding.size();
    EXPECT_GT(colliding, 100U);
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        const std::vector<Frame> frames = run(GetParam());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            ASSERT_TRUE(frames[i] == widest[i]) << environment::name(set) << ", frame " << i;
        }
    }
}

}  // namespace
}  // namespace ecods::test
