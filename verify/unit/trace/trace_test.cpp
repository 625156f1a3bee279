// What a trace says, and that it says all.

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <vector>

#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/trace/replay_text.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::trace_test {
namespace {

TEST(Trace, IsTheTextThatTheHeaderShows) {
    std::ostringstream out;
    World world({.broad_phase = BroadPhaseKind::sweep_and_prune});
    world.trace_to(out);
    const BodyId a = world.create_body(triangle, at(0));
    const BodyId b = world.create_body(triangle, at(0.1, -3, 0x1p-1074));
    world.update();
    world.set_pose(b, at(0, 0.5));
    world.set_pose(b, at(0, 0.5));  // is not a move
    EXPECT_INVALID(world.set_pose(b, at(std::nan(""))), Argument::pose);
    world.set_poses(std::vector<BodyId>{b, a}, std::vector<Pose>{at(1), at(2)});
    world.set_filter(a, {.groups = 10, .mask = ~std::uint64_t{0}});
    world.set_pair_enabled(b, a, false);
    world.set_user_data(a, 42);
    world.set_clearance(0.1875);
    world.set_clearance(0.1875);  // is no change
    EXPECT_INVALID(world.set_clearance(-1), Argument::distance);
    world.set_clearance({});
    world.set_shape(a, std::make_shared<MeshShape>(triangle));
    world.destroy_body(a);
    world.end_trace();
    world.destroy_body(b);
    const std::string head = "0x1p+0 0x0p+0 0x0p+0 ", mid = " 0x0p+0 0x1p+0 0x0p+0 ", last = " 0x0p+0 0x0p+0 0x1p+0 ";
    const auto pose = [&](const std::string& x, const std::string& y = "0x0p+0", const std::string& z = "0x0p+0") {
        return head + x + mid + y + last + z;
    };
    std::ostringstream digest;
    World same;
    same.create_body(triangle, at(0));
    same.create_body(triangle, at(0.1, -3, 0x1p-1074));
    same.update();
    digest << std::hex << same.digest();
    EXPECT_EQ(out.str(),
              "ecods-trace 2\nworld sweep_and_prune 0\n"
              "mesh 1 3 1\nv 0x0p+0 0x0p+0 0x0p+0\nv 0x1p+0 0x0p+0 0x0p+0\nv 0x0p+0 0x1p+0 -0x0p+0\nt 0 1 2\n"
              "create 1.0 1 " +
                  pose("0x0p+0") +
                  "\n"
                  "create 2.0 1 " +
                  pose("0x1.999999999999ap-4", "-0x1.8p+1", "0x0.0000000000001p-1022") +
                  "\n"
                  "update " +
                  digest.str() +
                  " 0\n"
                  "set_pose 2.0 " +
                  pose("0x0p+0", "0x1p-1") +
                  "\n"
                  "set_poses 2\np 2.0 " +
                  pose("0x1p+0") + "\np 1.0 " + pose("0x1p+1") +
                  "\n"
                  "set_filter 1.0 a ffffffffffffffff\nset_pair_enabled 2.0 1.0 0\nset_user_data 1.0 2a\n"
                  "set_clearance 0x1.8p-3\nset_clearance none\n"
                  "set_shape 1.0 1\ndestroy 1.0\n");
}

// A world that goes through all that can happen to it.
void live(World& world, int frame_count, std::uint32_t seed) {
    scenes::Random random(seed);
    const std::vector meshes{scenes::cube(0.5), scenes::torus(6, 4, 0.5), triangle};
    const auto pose = [&] {
        Pose p = at(random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4));
        p.R = random.rotation().toRotationMatrix();
        return p;
    };
    for (int frame = 0; frame < frame_count; ++frame) {
        for (int i = 0; i < 12; ++i) {
            const auto bodies = world.bodies();
            const auto any = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
            const std::uint32_t kind = bodies.size() < 10 ? 0 : random.below(10);
            if (kind < 2) {
                world.create_body(meshes[random.below(3)], pose());
            } else if (kind == 2 && bodies.size() > 20) {
                world.destroy_body(any());
            } else if (kind == 3) {
                const BodyId a = any(), b = any();
                if (a != b) world.set_pair_enabled(a, b, random.below(2) == 0);
            } else if (kind == 4) {
                world.set_filter(any(), {.groups = 1 + random.below(3), .mask = 1 + random.below(3)});
            } else if (kind == 5) {
                world.set_shape(any(), scenes::cube(0.25 + 0.125 * random.below(4)));
            } else if (kind == 6) {
                world.set_poses(std::vector<BodyId>{any(), any()}, std::vector<Pose>{pose(), pose()});
            } else {
                world.set_pose(any(), pose());
            }
        }
        if (frame % 4 == 2) world.set_clearance(frame % 12 == 10 ? std::nullopt : std::optional(0.01 * frame));
        world.update();
    }
}

TEST(Trace, ReplaysToTheSameWithAnyBroadPhase) {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    live(world, 30, 1);
    world.end_trace();
    for (const BroadPhaseKind kind : {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                      BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
        const ReplayReport report = replay_text(out.str(), {.broad_phase = kind, .checks_invariants = true});
        EXPECT_FALSE(report.difference) << report.difference->what;
        EXPECT_EQ(report.update_count, 30u);
        EXPECT_EQ(report.body_count, world.bodies().size());
        EXPECT_EQ(report.colliding_count, world.colliding_pairs().size());
        EXPECT_GT(report.colliding_count, 5u);
    }
}

// Begun in the middle of things, changes pending: what is here comes first.
TEST(Trace, MayBeginAtAnyTime) {
    World world;
    live(world, 5, 2);
    world.set_pose(world.bodies()[3], at(1, 1, 1));
    world.destroy_body(world.bodies()[0]);
    std::ostringstream out;
    world.trace_to(out);
    live(world, 10, 3);
    world.end_trace();
    const ReplayReport report = replay_text(out.str(), {.checks_invariants = true});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.update_count, 10u);
    EXPECT_EQ(report.body_count, world.bodies().size());
    EXPECT_EQ(report.colliding_count, world.colliding_pairs().size());
}

// A trace of the world that replays a trace is that trace.
TEST(Trace, AReplayCanBeTracedAgain) {
    std::ostringstream first, second;
    World world;
    world.trace_to(first);
    live(world, 10, 4);
    const ReplayReport report = replay_text(first.str(), {.set_up = [&](World& again) { again.trace_to(second); }});
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(first.str(), second.str());
}

TEST(Trace, WithoutOneNothingIsWrittenAndEndingNoneIsNoError) {
    World world;
    EXPECT_NO_THROW(world.end_trace());
    std::ostringstream out;
    world.trace_to(out);
    world.end_trace();
    const std::string text = out.str();
    live(world, 2, 5);
    EXPECT_EQ(out.str(), text);
}

// ---- streams that fail

class FullDisk final : public std::streambuf {
  public:
    explicit FullDisk(std::size_t size) : left(size) {}
    int overflow(int c) override { return left-- == 0 ? (left = 0, EOF) : c; }
    std::size_t left;
};

TEST(Trace, AStreamThatFailsEndsTheTraceAndNoCall) {
    for (const bool throws : {false, true}) {
        FullDisk disk(300);
        std::ostream out(&disk);
        if (throws) out.exceptions(std::ios::badbit | std::ios::failbit);
        World world, other;
        world.trace_to(out);
        EXPECT_NO_THROW(live(world, 4, 6));
        live(other, 4, 6);
        EXPECT_EQ(world.digest(), other.digest());
        EXPECT_THROW(world.end_trace(), TraceFailed);
        EXPECT_NO_THROW(world.end_trace());
    }
}

// A trace goes on when its world is moved.
TEST(Trace, GoesWithItsWorld) {
    std::ostringstream out;
    World first;
    first.trace_to(out);
    const BodyId a = first.create_body(triangle, at(0));
    World second = std::move(first);
    second.create_body(triangle, at(0.5));
    second.update();
    World third;
    third = std::move(second);
    third.set_pose(a, at(9));
    third.update();
    EXPECT_EQ(third.ended().size(), 1u);
    third.end_trace();
    const ReplayReport report = replay_text(out.str());
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.update_count, 2u);
}

// Editors and version control on Windows write CR LF, and a byte order mark.
TEST(Trace, IsReadWithTheLineEndsOfEditors) {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    world.create_body(triangle, at(0));
    world.create_body(triangle, at(0.5));
    world.update();
    world.end_trace();
    std::string text;
    for (const char c : out.str() + "note two words\n") text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const auto expect_whole = [](const std::string& trace) {
        const ReplayReport report = replay_text(trace);
        EXPECT_EQ(report.update_count, 1U);
        EXPECT_FALSE(report.difference);
    };
    expect_whole(out.str());
    expect_whole(text);
    expect_whole("\xef\xbb\xbf" + text);
    expect_whole("\xef\xbb\xbf" + out.str());
    // A trace of one kind of line end has no others.
    EXPECT_THROW(replay_text(out.str() + "update\r\n"), InvalidTrace);
    EXPECT_THROW(replay_text("ecods-trace 2\r\r\n" + text.substr(text.find('\n') + 1)), InvalidTrace);
}

}  // namespace
}  // namespace ecods::trace_test
