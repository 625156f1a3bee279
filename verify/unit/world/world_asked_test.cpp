// Subjects of questions that are no bodies: shapes and meshes at poses, in pairs with bodies and with each other; and
// how a world's questions use memories and count their work.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/slab_shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_asked_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class WorldAskedTest : public EachWorld {
  protected:
    // Two subjects, in every form in which they can be named; each answer is that of the free question.
    void expect_answers(const std::vector<Asked>& first, const std::vector<Asked>& second, const Posed<MeshShape>& a,
                        const Posed<MeshShape>& b) {
        for (const Asked& x : first) {
            for (const Asked& y : second) {
                EXPECT_EQ(world.intersects(x, y), intersects(a, b));
                EXPECT_EQ(world.relation(x, y, memory), relation(a, b));
                EXPECT_EQ(world.intersecting_triangles(x, y), intersecting_triangles(a, b));
                EXPECT_EQ(world.intersections(x, y, memory).size(), intersections(a, b).size());
                EXPECT_EQ(world.distance(x, y), distance(a, b));
                EXPECT_EQ(world.within(x, y, 0.25, memory), within(a, b, 0.25));
                EXPECT_EQ(world.closest(x, y).point_a, closest(a, b).point_a);
                EXPECT_EQ(world.closest(x, y, memory).kind, closest(a, b).kind);
                EXPECT_EQ(world.close_features(x, y, 0.25, memory).size(), close_features(a, b, 0.25).size());
            }
        }
    }

    std::shared_ptr<const ConvexSolid> large = std::make_shared<const ConvexSolid>(scenes::cube(1));
    std::shared_ptr<const ConvexSolid> small = std::make_shared<const ConvexSolid>(scenes::sphere(7, 5)->vertices());
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldAskedTest, broad_phases(), broad_phase_name);

TEST_P(WorldAskedTest, APairIsOfAnySubjects) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0));
    const CollisionFilter meets_none{.groups = 1, .mask = 0};
    scenes::Random random(3);
    for (const double distance : {0.25, 1.0, 1.75, 2.5}) {
        const Pose pose{random.rotation().toRotationMatrix(), distance * random.direction()};
        world.set_pose(b, pose);
        const std::vector<Asked> first = {a, {large, at(0)}, {*large, at(0)}};
        const std::vector<Asked> second = {
            b, {small, pose}, {Posed<MeshShape>(small, pose)}, {{small, pose}, meets_none}};
        const Posed<ConvexSolid> posed_a(large, at(0)), posed_b(small, pose);
        expect_answers(first, second, posed_a, posed_b);
        for (const Asked& x : first) {
            for (const Asked& y : second) {
                EXPECT_EQ(world.depth(x, y, memory), depth(posed_a, posed_b));
                EXPECT_EQ(world.signed_distance(x, y, memory), signed_distance(posed_a, posed_b));
                EXPECT_EQ(world.depth_bounds(x, y).has_value(), depth_bounds(posed_a, posed_b).has_value());
            }
        }
        // A mesh is a surface.
        const std::vector<Asked> mesh_a = {{large->mesh_ptr(), at(0)}, {surface_of(*large), at(0)}};
        const std::vector<Asked> mesh_b = {{small->mesh_ptr(), pose}, {surface_of(*small), pose}};
        const Posed<MeshShape> surface_a(surface_of(*large), at(0)), surface_b(surface_of(*small), pose);
        expect_answers(mesh_a, mesh_b, surface_a, surface_b);
        expect_answers(first, mesh_b, posed_a, surface_b);
        expect_answers(mesh_a, second, surface_a, posed_b);
    }
    EXPECT_TRUE(world.intersects(a, {world.shape(a), world.pose(a)})) << "a body and a copy of it are a pair";
}

TEST_P(WorldAskedTest, BadSubjectsAreRefusedOnEitherSide) {
    const BodyId a = world.create_body(large, at(0)), stale = world.create_body(small, at(9));
    world.destroy_body(stale);
    const Asked good(small, at(1));
    const auto refused = [&](const Asked& bad, auto why) {
        EXPECT_INVALID(world.distance(a, bad), why);
        EXPECT_INVALID(world.distance(bad, good), why);
        EXPECT_INVALID(world.relation(bad, a, memory), why);
        EXPECT_INVALID(world.relation(good, bad), why);
        EXPECT_INVALID(world.nearest(bad), why);
        EXPECT_INVALID(world.intersecting_bodies(bad), why);
        EXPECT_INVALID(world.cast(bad, Vec3(1, 0, 0)), why);
    };
    refused({small, at(infinity)}, Argument::pose);
    refused({small->mesh_ptr(), at(0, infinity)}, Argument::pose);
    refused({std::shared_ptr<const Mesh>(), at(0)}, Argument::null);
    EXPECT_INVALID(Asked(std::shared_ptr<const Shape>(), at(0)), Argument::null);
    EXPECT_THROW(static_cast<void>(world.distance(stale, good)), StaleBody);
    EXPECT_THROW(static_cast<void>(world.distance(good, stale)), StaleBody);
    EXPECT_THROW(static_cast<void>(world.distance({BodyId(), CollisionFilter()}, good)), StaleBody);
    EXPECT_THROW(static_cast<void>(world.distance(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.distance(a, {a, CollisionFilter()})), SameBody);
    const auto slab = std::make_shared<SlabShape>();
    EXPECT_INVALID(world.intersects(a, {slab, at(0)}), Question::intersects);
    EXPECT_INVALID(world.intersects({slab, at(0)}, good), Question::intersects);
    EXPECT_THROW(static_cast<void>(world.depth(good, {small->mesh_ptr(), at(0)})), NotSupported);
}

// Shapes of the caller's own are put in the order of their test's kinds.
TEST_P(WorldAskedTest, ShapesOfTheCallersOwnAreAsked) {
    world.set_test(slab_kind, slab_kind, std::make_shared<SlabTest>());
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    const auto slab = std::make_shared<SlabShape>(1);
    const BodyId a = world.create_body(slab, at(0)), b = world.create_body(cube, at(4));
    EXPECT_TRUE(world.intersects(a, {slab, at(2)}));
    EXPECT_FALSE(world.intersects({*slab, at(2.25)}, a, memory));
    EXPECT_TRUE(world.intersects({slab, at(2.5)}, b));
    EXPECT_TRUE(world.intersects(b, {slab, at(2.5)}));
    EXPECT_TRUE(world.intersects({cube, at(1.5)}, {slab, at(0)}));
    EXPECT_FALSE(world.intersects({cube, at(1.625)}, {slab, at(0)}, memory));
    EXPECT_INVALID(world.relation(a, {slab, at(2)}), Question::relation);
    EXPECT_EQ(world.intersecting_bodies({slab, at(2.5)}), (std::vector{b}));
    EXPECT_EQ(world.intersecting_bodies({{slab, at(2)}, CollisionFilter{.mask = 0}}), std::vector<BodyId>());
    EXPECT_EQ(world.cast({slab, at(-8)}, Vec3(12, 0, 0))->contact.time, 0.5);
    EXPECT_EQ(world.cast({slab, at(8)}, Vec3(-5, 0, 0), 0.5)->body, b) << "up to the limit itself";
}

// A body with a filter passes over what either filters out.
TEST_P(WorldAskedTest, AFilterOfItsOwnCountsBesideThatOfTheBody) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(2)),
                 c = world.create_body(cube, at(4));
    world.set_filter(b, {.groups = 2});
    const CollisionFilter meets_second{.groups = 1, .mask = 2}, meets_first{.groups = 1, .mask = 1};
    EXPECT_EQ(world.nearest(a)->body, b);
    EXPECT_EQ(world.nearest({a, meets_second})->body, b);
    EXPECT_EQ(world.nearest({a, meets_first})->body, c);
    EXPECT_EQ(world.cast({a, meets_first}, Vec3(8, 0, 0))->body, c);
    world.set_pose(b, at(0.5));
    EXPECT_EQ(world.intersecting_bodies(a), (std::vector{b})) << "and not itself";
    EXPECT_EQ(world.intersecting_bodies({a, meets_first}), std::vector<BodyId>());
    world.set_pose(b, at(2));
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.nearest({a, meets_second}), std::nullopt);
    EXPECT_EQ(world.nearest({{cube, at(0)}, meets_second}), (NearestBody{b, 1}));
}

TEST_P(WorldAskedTest, TheShapeOfAPosedSubjectIsKept) {
    auto shape = std::make_shared<const MeshShape>(scenes::cube(0.5));
    const std::weak_ptr<const MeshShape> watched = shape;
    const BodyId a = world.create_body(cube, at(3));
    auto asked = std::make_optional<Asked>(std::move(shape), at(0));
    EXPECT_EQ(world.nearest(*asked), (NearestBody{a, 2}));
    const Asked copy = *asked;
    asked.reset();
    EXPECT_EQ(world.distance(copy, a), 2);
    EXPECT_EQ(watched.use_count(), 1);
}

// ---- memories and counts

// The test of two slabs that asks questions of its own within each, in the thread's own memory, to any depth.
class NestedTest final : public TwoBodyTest {
  public:
    NestedTest(const World& world, BodyId mesh) : world_(world), mesh_(mesh) {}

    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        EXPECT_NE(ask.memory, nullptr) << "a world gives the memory";
        const MeshShape cube(scenes::cube(0.5));
        const Posed<MeshShape> x(cube, a.pose), y(cube, b.pose);
        const double d = ecods::distance(x, y, ask), in_own = ecods::distance(x, y);
        EXPECT_EQ(d, in_own);
        EXPECT_EQ(world_.distance(mesh_, {cube, a.pose}), ecods::distance({cube, world_.pose(mesh_)}, x));
        if (depth_ < 3) {
            const Deeper deeper(depth_);
            EXPECT_EQ(world_.intersects({*a.what, a.pose}, {*b.what, b.pose}), d == 0);
            EXPECT_EQ(ecods::distance(x, y), d) << "after the question within";
        }
        if (throws) throw std::runtime_error("as it was told to");
        return d == 0;
    }

    bool throws = false;

  private:
    struct Deeper {
        explicit Deeper(int& counter) : depth(counter) { ++depth; }
        ~Deeper() { --depth; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;

        int& depth;
    };

    const World& world_;
    BodyId mesh_;
    mutable int depth_ = 0;
};

TEST_P(WorldAskedTest, QuestionsMayBeAskedWithinQuestions) {
    const BodyId mesh = world.create_body(cube, at(0, 3));
    const auto test = std::make_shared<NestedTest>(world, mesh);
    world.set_test(slab_kind, slab_kind, test);
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    const auto slab = std::make_shared<SlabShape>(0.5);
    const BodyId a = world.create_body(slab, at(0)), b = world.create_body(slab, at(1));
    QueryCounts in_own, in_memory;
    EXPECT_TRUE(world.intersects(a, b));
    EXPECT_TRUE(world.intersects(a, b, in_own));
    EXPECT_TRUE(world.intersects(a, b, {memory, in_memory}));
    EXPECT_EQ(in_own, in_memory);
    EXPECT_EQ(in_memory, memory.counts()) << "questions within it that are asked in another memory count there";
    EXPECT_EQ(in_own.queries, 1u);
    EXPECT_EQ(world.intersecting_bodies({slab, at(1.5)}), (std::vector{b}));
}

// Work is counted also where a test throws, and the memory is lent again afterwards.
TEST_P(WorldAskedTest, ATestThatThrowsHasWorked) {
    const BodyId mesh = world.create_body(cube, at(0, 3));
    const auto test = std::make_shared<NestedTest>(world, mesh);
    world.set_test(slab_kind, slab_kind, test);
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    const auto slab = std::make_shared<SlabShape>(0.5);
    const BodyId a = world.create_body(slab, at(0)), b = world.create_body(slab, at(1));
    QueryCounts expected;
    EXPECT_TRUE(world.intersects(a, b, expected));
    test->throws = true;
    for (int i = 0; i < 3; ++i) {
        // The innermost question throws, through those around it: no question after it is asked.
        QueryCounts counts;
        EXPECT_THROW(static_cast<void>(world.intersects(a, b, counts)), std::runtime_error);
        EXPECT_EQ(counts, expected);
    }
    test->throws = false;
    EXPECT_TRUE(world.intersects(a, b));
}

// Statistics count updates. Questions are counted where their Ask says, the same in any memory.
TEST_P(WorldAskedTest, StatisticsDoNotCountQuestions) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < 20; ++i) bodies.push_back(world.create_body(i % 2 == 0 ? large : small, at(1.5 * i)));
    world.update();
    const QueryCounts before = world.statistics().queries;
    const std::vector<Pose> poses = {at(30), at(-5)};
    const std::vector<std::function<void(const Ask&)>> questions = {
        [&](const Ask& ask) {
            std::ignore = world.relation(bodies[0], {small, at(1)}, ask);
        },
        [&](const Ask& ask) { std::ignore = world.closest(bodies[0], bodies[3], ask); },
        [&](const Ask& ask) { std::ignore = world.nearest(bodies[4], infinity, ask); },
        [&](const Ask& ask) { std::ignore = world.closest_pair(infinity, ask); },
        [&](const Ask& ask) { std::ignore = world.cast(bodies[4], Vec3(9, 0, 0), 1, ask); },
        [&](const Ask& ask) {
            std::ignore = world.meetings({&bodies[3], 2}, poses, ask);
        },
        [&](const Ask& ask) {
            std::ignore = world.intersecting_bodies({large, at(4)}, ask);
        },
        [&](const Ask& ask) {
            std::ignore = world.first_hit(Segment{Vec3(-3, 0, 0), Vec3(30, 0.5, 0.25)}, {}, ask);
        },
        [&](const Ask& ask) {
            std::ignore = world.all_hits(Segment{Vec3(-3, 0, 0), Vec3(30, 0.5, 0.25)}, {}, ask);
        },
    };
    constexpr std::size_t closest_pair_at = 3;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        SCOPED_TRACE(i);
        QueryMemory fresh;
        QueryCounts in_own, twice;
        questions[i](fresh);
        std::jthread([&] { questions[i](in_own); }).join();
        EXPECT_EQ(in_own, fresh.counts());
        EXPECT_GT(in_own.queries, 0u);
        for (int k = 0; k < 2; ++k) questions[i](twice);
        if (i == closest_pair_at) {
            EXPECT_LE(twice.queries, 2 * in_own.queries) << "it begins with the pair that it found in the same memory";
        } else {
            EXPECT_EQ(twice.queries, 2 * in_own.queries);
        }
    }
    EXPECT_EQ(world.statistics().queries, before);
}

TEST_P(WorldAskedTest, ManyThreadsAskInTheirOwnMemories) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < 40; ++i) bodies.push_back(world.create_body(i % 2 == 0 ? large : small, at(1.5 * i, i % 3)));
    world.update();
    for (const BodyId body : bodies) world.set_pose(body, at(1.25 * body.slot, body.slot % 3));
    const auto answers_of = [&](const World& asked) {
        std::vector<double> answers;
        for (const BodyId body : bodies) {
            const Asked there(small, at(1.25 * body.slot, 0.5, 0.25));
            answers.push_back(asked.distance(body, there));
            answers.push_back(asked.nearest(there)->distance);
            answers.push_back(static_cast<double>(asked.intersecting_bodies(there).size()));
            const auto met = asked.cast(there, Vec3(0, -3, 0.5));
            answers.push_back(met ? met->contact.time : -1);
        }
        answers.push_back(static_cast<double>(asked.depths().size()));
        return answers;
    };
    std::vector<std::vector<double>> answers(4);
    {
        std::vector<std::jthread> threads;
        for (auto& own : answers) threads.emplace_back([&] { own = answers_of(world); });
    }
    for (const auto& own : answers) EXPECT_EQ(own, answers_of(world));
}

// Of questions about one subject those about a body alone are written, in the thread's own memory only; the answer does
// not depend on it, nor do counts and a witness.
TEST_P(WorldAskedTest, TracesHaveQuestionsAboutBodiesInTheThreadsOwnMemory) {
    const BodyId a = world.create_body(cube, at(0));
    world.create_body(cube, at(3));
    std::stringstream out;
    world.trace_to(out, {.questions = true});
    QueryCounts counts;
    PairWitness witness;
    const World& asked = world;
    EXPECT_EQ(asked.nearest(a)->distance, 2);
    EXPECT_EQ(asked.nearest(a, infinity, counts)->distance, 2);
    EXPECT_EQ(asked.nearest(a, infinity, {witness, counts})->distance, 2);
    EXPECT_EQ(asked.nearest(a, infinity, {memory, counts})->distance, 2);
    EXPECT_EQ(asked.nearest({world.shape(a), at(0.5)})->distance, 0);
    EXPECT_EQ(asked.nearest({{cube, at(-3)}, CollisionFilter()})->distance, 2);
    EXPECT_EQ(asked.nearest({a, CollisionFilter()})->distance, 2);
    EXPECT_EQ(asked.cast(a, Vec3(4, 0, 0))->contact.time, 0.5);
    EXPECT_EQ(asked.cast({cube, at(-3)}, Vec3(4, 0, 0))->contact.time, 0.5);
    world.end_trace();
    const ReplayReport report = replay(out);
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.question_count, 4u);
}

}  // namespace
}  // namespace ecods::world_asked_test
