// A check that cannot fail checks nothing: here each is given a world that is not what it should be.
#include <gtest/gtest.h>

#include <array>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/mesh_form.hpp"
#include "fuzz/base/recipe.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/solid_questions.hpp"
#include "fuzz/motion/meshes.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

// Three cubes in a row, of which the first two touch.
class Checks : public testing::Test {
  protected:
    Checks() {
        for (const double x : {0.0, 1.0, 3.0}) ids.push_back(world.create_body(cube, at(x)));
        world.update();
        truth.look_at(world);
    }
    static Pose at(double x) {
        Pose pose;
        pose.t[0] = x;
        return pose;
    }
    // What the check complains of; empty if of nothing.
    template <class Check>
    static std::string complaint(Check check) {
        try {
            check();
        } catch (const CheckFailed& error) {
            return error.check;
        }
        return "";
    }

    Pose across{Mat3::Identity(), Vec3(0.5, 0.25, 0.25)};  // where the first and the second cross
    std::shared_ptr<const Mesh> cube = scenes::cube(0.5);
    World world;
    std::vector<BodyId> ids;
    Truth truth;
    Counters counters;
};

TEST_F(Checks, MeshesAreWhatTheirRecipesPromise) {
    EXPECT_EQ(complaint([&] { require_solid("cube", *cube); }), "");
    const std::vector<Triangle> half(cube->triangles().begin() + 1, cube->triangles().end());
    const auto open = Mesh::create({cube->vertices().begin(), cube->vertices().end()}, half);
    EXPECT_EQ(complaint([&] { require_solid("cube", *open); }), recipe_check);
}

TEST_F(Checks, NothingToComplainOf) {
    const auto expected = true_collisions(world, truth);
    EXPECT_EQ(expected, numbers_of(std::vector<BodyPair>{{ids[0], ids[1]}}));
    EXPECT_EQ(complaint([&] {
                  check_boxes(world, truth, counters);
                  check_candidates(world, counters);
                  check_answers(world, truth, counters);
                  check_queries(world, truth, ids[0], counters);
                  check_collisions(world, expected, truth);
                  check_events(world, {});
                  check_invariants(world);
                  check_fresh_world(world, {.order = 3});
                  check_trace(world, {}, {.broad_phase = BroadPhaseKind::sweep_and_prune});
              }),
              "");
    EXPECT_EQ(counters["checked: pairs against the oracle"], 1U);
}

TEST_F(Checks, BoxesThatDoNotContainTheBody) {
    World other;
    for (const double x : {0.0, 1.0, 3.5}) other.create_body(cube, at(x));
    EXPECT_EQ(complaint([&] { check_boxes(other, truth, counters); }), "box contains body");
}

TEST_F(Checks, ListsBeforeTheUpdate) {
    world.set_pose(ids[2], at(2));
    EXPECT_EQ(complaint([&] { check_candidates(world, counters); }), "candidate pairs");
    truth.look_at(world);
    EXPECT_EQ(complaint([&] { check_collisions(world, true_collisions(world, truth), truth); }), "colliding pairs");
    EXPECT_EQ(complaint([&] { check_fresh_world(world, {}); }), "fresh world, collisions");
    EXPECT_EQ(complaint([&] { check_invariants(world); }), "invariants");
}

TEST_F(Checks, AnswersForOtherPoses) {
    world.set_pose(ids[1], across);
    EXPECT_EQ(complaint([&] { check_answers(world, truth, counters); }), "relation");
    world.set_pose(ids[1], at(1));
    world.set_shape(ids[1], Mesh::create({Vec3(-0.5, 0, 0)}, {{0, 0, 0}}));
    EXPECT_EQ(complaint([&] { check_answers(world, truth, counters); }), "triangle pairs");
    world.set_pose(ids[1], at(9));
    EXPECT_EQ(complaint([&] { check_queries(world, truth, ids[0], counters); }), "bodies that a shape touches");
}

TEST_F(Checks, EventsFromAnotherPast) {
    EXPECT_EQ(complaint([&] { check_events(world, {{ids[0], ids[1]}}); }), "pairs that began");
    EXPECT_EQ(complaint([&] { check_events(world, {{ids[1], ids[2]}}); }), "pairs that ended");
}

TEST_F(Checks, WorldsThatWereToldSomethingElse) {
    World other;
    for (const double x : {0.0, 1.0, 3.5}) other.create_body(cube, at(x));
    other.update();
    EXPECT_EQ(complaint([&] { check_same(world, other, counters); }), "worlds given the same calls");
}

TEST_F(Checks, TracesOfShapesThatAreReadAsOthers) {
    UserTests().add_to(world);
    world.create_body(std::make_shared<UserShape>(cube, first_user_kind), at(3.5));
    ReplayOptions reading;
    reading.set_up = [](World& made) { UserTests().add_to(made); };
    reading.read_shape = [](ShapeKind kind, std::string_view) {
        return std::make_shared<UserShape>(scenes::cube(9), kind);
    };
    EXPECT_EQ(complaint([&] { check_trace(world, {.write_shape = write_user_shape}, reading); }), "trace and replay");
}

// The second world is given something else, or nothing yet.
TEST_F(Checks, PairsOfSolidsOfOtherBodies) {
    const auto solid = make_shape(cube, MeshForm::solid);
    World first, other;
    for (World* each : {&first, &other}) {
        each->create_body(solid, at(0));
        each->create_body(solid, at(0.5));
        each->set_relations(true);
        each->update();
    }
    const std::array<World*, 2> worlds{&first, &other};
    EXPECT_EQ(complaint([&] { check_solids(worlds, 1, counters); }), "");
    EXPECT_EQ(counters["checked: relations in worlds"], 1U);
    EXPECT_GT(counters["checked: bodies that contain a point"], 0U);
    EXPECT_EQ(complaint([&] { check_fresh_world(first, {}); }), "");
    other.set_pose(other.bodies()[1], at(1));
    other.update();
    EXPECT_EQ(complaint([&] { check_solids(worlds, 1, counters); }), "relations");
    first.set_relations(false);
    other.set_relations(false);
    for (World* each : worlds) each->update();
    EXPECT_EQ(complaint([&] {
                  for (std::uint32_t seed = 0; seed < 20; ++seed) check_solids(worlds, seed, counters);
              }),
              "bodies that contain a point");
}

TEST_F(Checks, FiltersCount) {
    world.set_pair_enabled(ids[0], ids[1], false);
    EXPECT_EQ(complaint([&] { check_candidates(world, counters); }), "candidate pairs");
    world.update();
    EXPECT_EQ(complaint([&] {
                  check_candidates(world, counters);
                  check_collisions(world, true_collisions(world, truth), truth);
                  check_fresh_world(world, {});
              }),
              "");
    EXPECT_TRUE(world.colliding_pairs().empty());
}

TEST_F(Checks, ShapesThatTheOracleDoesNotKnowAreLeftOut) {
    UserTests().add_to(world);
    const BodyId user = world.create_body(std::make_shared<UserShape>(cube, first_user_kind), at(0.5));
    world.update();
    truth.look_at(world);
    EXPECT_FALSE(truth.knows(user));
    EXPECT_EQ(complaint([&] { check_collisions(world, true_collisions(world, truth), truth); }), "");
    Truth knows_all(mesh_of);
    knows_all.look_at(world);
    EXPECT_EQ(true_collisions(world, knows_all).size(), 3U);
    EXPECT_EQ(complaint([&] { check_collisions(world, true_collisions(world, knows_all), knows_all); }), "");
}

TEST_F(Checks, OnlyWhatChangedIsAskedAgain) {
    truth.look_at(world);
    ASSERT_EQ(truth.pairs().size(), 1U);
    EXPECT_FALSE(truth.pairs()[0].is_changed);
    world.set_pose(ids[0], across);
    truth.look_at(world);
    EXPECT_TRUE(truth.pairs()[0].is_changed);
    EXPECT_EQ(truth.pairs()[0].verdict.relation, Relation::crossing);
}

}  // namespace
}  // namespace ecods::fuzz
