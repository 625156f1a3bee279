// Questions in a trace: written where they are wanted, asked again by the replay, and compared.
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <tuple>

#include "ecods/error.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::trace_questions_test {
namespace {

// Of three cubes in a row, of which the second is asked about.
std::string traced(const TraceOptions& options) {
    World world;
    std::ostringstream out;
    world.trace_to(out, options);
    const auto cube = scenes::cube(0.5);
    std::vector<BodyId> bodies;
    for (const double x : {0.0, 3.0, 6.0}) bodies.push_back(world.create_body(cube, at(x)));
    for (const double x : {20.0, 20.5}) world.create_body(std::make_shared<const ConvexSolid>(cube), at(x));
    world.update();
    std::ignore = world.first_hit(Segment{Vec3(-2, 0.25, 0.125), Vec3(8, 0.25, 0.125)});
    std::ignore =
        world.first_hit(Ray{Vec3(-2, 0.25, 0.125), Vec3(1, 0, 0)}, CollisionFilter{.groups = 2, .mask = 0x10});
    std::ignore = world.all_hits(Segment{Vec3(-2, 0.25, 0.125), Vec3(8, 0.25, 0.125)}, CollisionFilter{});
    std::ignore = world.all_hits(Ray{Vec3(9, 0, 0), Vec3(-1, 0, 0), 5.5});
    std::ignore = world.nearest(bodies[1]);
    std::ignore = world.nearest(bodies[1], 0.5);
    std::ignore = world.closest_pair();
    std::ignore = world.cast(bodies[0], Vec3(8, 0, 0));
    std::ignore = world.cast(bodies[0], Vec3(8, 0, 0), 0.25);
    std::ignore = world.meetings(std::vector{bodies[2], bodies[0]}, std::vector{at(0), at(6)});
    const Turn turn{{1, 0, 0, 0.5}, Vec3(3, 3, 0), Vec3(3, 3, 1)};
    std::ignore = world.cast(bodies[0], turn);
    std::ignore = world.cast(bodies[0], Straight{at(8)});
    std::ignore =
        world.meetings(std::vector{bodies[2], bodies[0]}, std::vector<Motion>{turn, Translation{Vec3(4, 0.1, 0)}});
    std::ignore = world.meetings(std::vector{bodies[2], bodies[0]}, std::vector<Motion>{Straight{at(0)}, turn});
    const Along nodes{{{{2, 0, 0, 0}, Vec3(3, 0, 0)}, {{0, 0, 1, 0}, Vec3(3, 0, 0)}, {{0, 0, 1, 1}, Vec3(4, 0.1, 0)}}};
    std::ignore = world.cast(bodies[0], nodes, 0.75);
    std::ignore = world.meetings(std::vector{bodies[2], bodies[0]}, std::vector<Motion>{nodes, Translation()});
    std::ignore = world.cast_to_distance(bodies[0], Vec3(8, 0, 0), 0.5, 0.75);
    const Segment through{Vec3(-2, 0.25, 0.125), Vec3(24, 0.25, 0.125)};
    std::ignore = world.sided_hits(through);
    std::ignore = world.inside_parts(through, CollisionFilter{});
    std::ignore = world.sided_hits(Ray{Vec3(24, 0, 0), Vec3(-1, 0, 0)});
    std::ignore = world.inside_parts(Ray{Vec3(20, 0, 0), Vec3(1, 0, 0), 5.5});
    std::ignore = world.bodies_containing(Vec3(0.25, 0.25, 0));
    std::ignore = world.depths();
    std::ignore = world.signed_distances(1);
    world.set_pose(bodies[1], at(3, 0.25));
    QueryMemory memory;
    std::ignore = world.nearest(bodies[1], World::no_limit, memory);
    EXPECT_INVALID(world.first_hit(Segment{Vec3(0, 0, 0), Vec3(0, 0, std::numeric_limits<double>::infinity())}),
                   Argument::segment);
    world.update();
    world.end_trace();
    return out.str();
}

std::size_t count_of(const std::string& word, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

ReplayReport replayed(const std::string& text, BroadPhaseKind kind = BroadPhaseKind::automatic) {
    std::istringstream in(text);
    return replay(in, {.broad_phase = kind});
}

TEST(TraceQuestions, AreWrittenWhereTheyAreWanted) {
    const std::string without = traced({}), with = traced({.questions = true});
    EXPECT_EQ(count_of("\nfirst_hit", without) + count_of("\nnearest", without), 0u);
    EXPECT_EQ(count_of("\nfirst_hit ", with), 1u);
    EXPECT_EQ(count_of("\nfirst_hit_of_ray ", with), 1u);
    EXPECT_EQ(count_of("\nall_hits ", with), 1u);
    EXPECT_EQ(count_of("\nall_hits_of_ray ", with), 1u);
    EXPECT_EQ(count_of("\nnearest ", with), 2u) << "those without a memory of the caller's";
    EXPECT_EQ(count_of("\nclosest_pair ", with), 1u);
    EXPECT_EQ(count_of("\ncast ", with), 2u);
    EXPECT_EQ(count_of("\nmeetings ", with), 1u);
    EXPECT_EQ(count_of("\ncast_of ", with), 3u);
    EXPECT_EQ(count_of("\nmeetings_of ", with), 3u);
    EXPECT_EQ(count_of(" translated ", with) + count_of(" turned ", with), 5u);
    EXPECT_EQ(count_of(" along 3 0x1p+1 ", with), 2u);
    for (const std::string name : {"cast_to_distance", "sided_hits", "sided_hits_of_ray", "inside_parts",
                                   "inside_parts_of_ray", "bodies_containing"}) {
        EXPECT_EQ(count_of("\n" + name + " ", with), 1u) << name;
    }
    EXPECT_EQ(count_of("\ndepths ", with), 1u);
    EXPECT_EQ(count_of("\nsigned_distances ", with), 1u);
    EXPECT_NE(with.find(" inf 2 10\n"), std::string::npos) << with;
    EXPECT_NE(with.find(" inf\n"), std::string::npos);
    EXPECT_EQ(replayed(without).question_count, 0u);
    for (const auto kind : {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                            BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
        const ReplayReport report = replayed(with, kind);
        EXPECT_FALSE(report.difference) << report.difference->what;
        EXPECT_EQ(report.question_count, 24u);
        EXPECT_EQ(report.update_count, 2u);
        EXPECT_EQ(report.call_count, 6u + 2 + 24);
    }
}

// Entering is asked of solids alone. What has no body, or a filter, is not written.
TEST(TraceQuestions, EnteringIsWrittenWithItsLimit) {
    World world;
    const auto solid = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    std::stringstream trace;
    world.trace_to(trace, {.questions = true});
    const BodyId moved = world.create_body(solid, at(0));
    world.create_body(solid, at(3));
    EXPECT_TRUE(world.entering(moved, Vec3(8, 0.25, 0)));
    EXPECT_FALSE(world.entering(moved, Vec3(8, 0.25, 0), 0.25));
    EXPECT_TRUE(world.entering({solid, at(0)}, Vec3(8, 0.25, 0)));
    EXPECT_TRUE(world.entering({moved, CollisionFilter{}}, Vec3(8, 0.25, 0)));
    QueryMemory memory;
    EXPECT_TRUE(world.entering(moved, Vec3(8, 0.25, 0), 1, memory));
    world.end_trace();
    std::string text = trace.str();
    EXPECT_EQ(count_of("\nentering ", text), 2u);
    EXPECT_NE(text.find(" 0x1p-2\n"), std::string::npos) << text;
    EXPECT_FALSE(replayed(text).difference);
    EXPECT_EQ(replayed(text).question_count, 2u);
    char& digit = text[text.find("\nentering ") + 12];
    digit = digit == '7' ? '8' : '7';
    EXPECT_TRUE(replayed(text).difference);
}

// Hits of many lines are a question for each line.
TEST(TraceQuestions, HitsOfManyLinesAreWrittenLineByLine) {
    World world;
    world.create_body(scenes::cube(0.5), at(0));
    std::stringstream trace;
    world.trace_to(trace, {.questions = true});
    const std::vector<Segment> segments(3, {Vec3(-2, 0.25, 0.125), Vec3(8, 0.25, 0.125)});
    EXPECT_EQ(world.all_hits(segments).hits.size(), 6u);
    const std::vector<Ray> rays(2, {.origin = Vec3(9, 0.25, 0.125), .direction = Vec3(-1, 0, 0)});
    EXPECT_EQ(world.all_hits(rays).hits.size(), 4u);
    QueryMemory memory;
    EXPECT_EQ(world.all_hits(rays, {}, memory).hits.size(), 4u);
    world.end_trace();
    EXPECT_EQ(count_of("\nall_hits ", trace.str()), 3u);
    EXPECT_EQ(count_of("\nall_hits_of_ray ", trace.str()), 2u);
    const ReplayReport report = replay(trace);
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.question_count, 5u);
}

// Each of the lines with another digest is named.
TEST(TraceQuestions, TheFirstOtherAnswerIsNamed) {
    const std::string text = traced({.questions = true});
    for (const std::string name :
         {"first_hit", "first_hit_of_ray", "all_hits", "all_hits_of_ray", "nearest", "closest_pair", "cast", "meetings",
          "cast_of", "meetings_of", "bodies_containing", "depths", "signed_distances", "cast_to_distance", "sided_hits",
          "sided_hits_of_ray", "inside_parts", "inside_parts_of_ray"}) {
        const std::size_t line = text.find("\n" + name + " ") + 1;
        const std::size_t digest = line + name.size() + 1;
        std::string wrong = text;
        wrong[digest + 3] = wrong[digest + 3] == '7' ? '8' : '7';
        const ReplayReport report = replayed(wrong);
        ASSERT_TRUE(report.difference) << name;
        EXPECT_NE(report.difference->what.find("answer to " + name + " is "), std::string::npos);
        const std::size_t more = name.starts_with("meetings") ? 2 : 0;  // lines, of the bodies
        EXPECT_EQ(report.difference->line, count_of("\n", text.substr(0, line)) + 1 + more);
    }
}

// Where the world was not empty at the beginning, other bodies may have the least ids.
TEST(TraceQuestions, OfAWorldThatWasNotEmptyAreAskedAndNotCompared) {
    World world;
    const auto cube = scenes::cube(0.5);
    world.destroy_body(world.create_body(cube, at(0)));
    const BodyId a = world.create_body(cube, at(0));
    world.create_body(cube, at(4));
    std::stringstream trace;
    world.trace_to(trace, {.questions = true});
    std::ignore = world.nearest(a);
    world.end_trace();
    const ReplayReport report = replay(trace);
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.question_count, 1u);
}

TEST(TraceQuestions, WhatIsNoQuestionIsRefused) {
    const std::string head = "ecods-trace 2\nworld brute_force 0\n";
    const auto refused = [&](const std::string& line) {
        EXPECT_THROW(replayed(head + line + "\n"), InvalidTrace) << line;
    };
    EXPECT_EQ(replayed(head + "closest_pair 0 inf\n").question_count, 0u) << "which has another digest";
    refused("first_hit 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
    refused("first_hit 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 inf none");
    refused("first_hit_of_ray 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 inf none");
    refused("first_hit_of_ray 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 -0x1p+0 none");
    refused("closest_pair 0 -0x1p+0");
    refused("nearest 0 1.0 inf");
    refused("cast 0 1.0 0x0p+0 0x0p+0 0x0p+0 0x1p+0");
    refused("signed_distances 0 -0x1p+0");
    refused("depths 0 inf");
    refused("meetings 0 1");
    refused("meetings 0 0 0");
    const std::string cube =
        "mesh 1 3 1\nv 0x0p+0 0x0p+0 0x0p+0\nv 0x1p+0 0x0p+0 0x0p+0\nv 0x0p+0 0x1p+0 0x0p+0\nt 0 1 2\n";
    const std::string body = cube +
                             "create 1.0 1 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
                             "0x1p+0 0x0p+0\n";
    refused("meetings_of 0 1");
    refused("meetings_of 0 0 0");
    refused(body + "meetings_of 0 1\nm 1.0 spun 0x0p+0 0x0p+0 0x0p+0");
    refused(body + "meetings_of 0 1\nm 1.0 translated 0x0p+0 0x0p+0");
    refused(body + "meetings_of 0 1\nm 1.0 turned 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
    refused(body + "cast_of 0 1.0 turned 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0");
    const std::string node = " 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0", numbers = node + node + node;
    refused(body + "cast_of 0 1.0 along 3" + numbers);
    refused(body + "cast_of 0 1.0 along 2" + numbers + " 0x1p+0");
    refused(body + "cast_of 0 1.0 along 1" + node + " 0x1p+0");
    refused(body + "cast_of 0 1.0 along 4294967296" + numbers + " 0x1p+0");
    refused(body + "meetings_of 0 1\nm 1.0 along 0");
    refused(body + "meetings_of 0 1\nm 1.0 along");
    EXPECT_EQ(replayed(head + body + "cast_of 0 1.0 along 3" + numbers + " 0x1p+0\n").call_count, 2u);
    EXPECT_EQ(replayed(head + body + "meetings_of 0 1\nm 1.0 translated 0x0p+0 0x0p+0 0x0p+0\n").call_count, 2u);
    EXPECT_EQ(replayed(head + "meetings 0 0\n").question_count, 0u) << "which has another digest";
}

}  // namespace
}  // namespace ecods::trace_questions_test
