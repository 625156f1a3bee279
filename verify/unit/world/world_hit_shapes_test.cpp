// What is in the way, among shapes of the caller's own: what a world answers is what asking all of them one by one
// says, in the order that is promised; and kinds that do not answer are refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/slab_shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_hit_shapes_test {
namespace {

class WorldHitShapesTest : public EachWorld {
  protected:
    WorldHitShapesTest() {
        world.set_test(slab_kind, slab_kind, std::make_shared<SlabTest>());
        world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    }

    // Integers: many ties, and boxes that touch.
    double integer(int below) { return random.below(static_cast<std::uint32_t>(below)); }
    Pose any_pose() { return at(integer(side), integer(side), integer(4)); }
    Vec3 any_motion() {
        constexpr std::array steps = {-8.0, -2.0, 0.0, 0.0, 1.0, 4.0, 16.0};
        return {steps[random.below(7)], steps[random.below(7)], steps[random.below(7)]};
    }
    void fill(int count) {
        for (int i = 0; i < count; ++i) {
            bodies.push_back(world.create_body(shapes[random.below(3)], any_pose()));
            if (random.below(4) == 0) world.set_filter(bodies.back(), {.groups = 2});
        }
        std::ranges::sort(bodies);
    }
    void move_some() {
        for (int i = 0; i < 30; ++i)
            world.set_pose(bodies[random.below(static_cast<std::uint32_t>(bodies.size()))], any_pose());
        const BodyId a = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))],
                     b = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        if (a != b) world.set_pair_enabled(a, b, !world.is_pair_enabled(a, b));
    }

    bool may_meet(BodyId a, BodyId b) {
        return a != b && world.is_pair_enabled(a, b) && ecods::may_meet(world.filter(a), world.filter(b));
    }
    std::vector<BodyHit> model_of_all_hits(const Ray& ray, const std::optional<CollisionFilter>& filter) {
        std::vector<BodyHit> hits;
        for (const BodyId body : bodies) {
            if (filter && !ecods::may_meet(*filter, world.filter(body))) continue;
            for (const Hit& hit : world.shape(body)->all_hits(ray, world.pose(body), memory)) {
                hits.push_back({body, hit});
            }
        }
        std::ranges::stable_sort(hits, {}, [](const BodyHit& h) { return std::pair(h.hit.parameter, h.body); });
        rank_by_parameter(hits);
        return hits;
    }
    static auto fields(const BodyHit& h) {
        return std::tuple(h.body, h.hit.parameter, h.hit.rank, h.hit.triangle(), h.hit.kind);
    }
    static void require_same(const std::vector<BodyHit>& got, const std::vector<BodyHit>& expected) {
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) ASSERT_EQ(fields(got[i]), fields(expected[i])) << i;
    }
    Posed<Shape> posed(BodyId body) {
        kept.push_back(world.shape(body));
        return {*kept.back(), world.pose(body)};
    }

    int side = 12;
    scenes::Random random{23};
    SlabTest test;
    std::array<std::shared_ptr<const Shape>, 3> shapes = {
        std::make_shared<SlabShape>(0.5), std::make_shared<SlabShape>(0.25), std::make_shared<SlabShape>(1)};
    std::vector<BodyId> bodies;
    std::vector<std::shared_ptr<const Shape>> kept;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldHitShapesTest, broad_phases(), broad_phase_name);

TEST_P(WorldHitShapesTest, HitsAreThoseOfAllBodiesInOrder) {
    fill(200);
    std::size_t count = 0, ties = 0;
    for (int frame = 0; frame < 12; ++frame) {
        for (int i = 0; i < 12; ++i) {
            Ray ray{any_pose().t, any_motion(), random.below(3) == 0 ? integer(3) : 1};
            if (ray.direction == Vec3::Zero()) ray.direction = Vec3::UnitX();
            std::optional<CollisionFilter> filter;
            if (random.below(2) == 0) filter = CollisionFilter{.mask = 2};
            const auto expected = model_of_all_hits(ray, filter);
            ASSERT_NO_FATAL_FAILURE(require_same(world.all_hits(ray, filter, memory), expected));
            const auto first = world.first_hit(ray, filter);
            ASSERT_EQ(first.has_value(), !expected.empty());
            if (first) {
                ASSERT_EQ(fields(*first), fields(expected[0]));
            }
            if (ray.max_parameter == 1) {
                const Segment segment{ray.origin, ray.origin + ray.direction};
                ASSERT_NO_FATAL_FAILURE(require_same(world.all_hits(segment, filter), expected));
                ASSERT_EQ(world.first_hit(segment, filter, memory).has_value(), !expected.empty());
            }
            count += expected.size();
            ties += !expected.empty() && expected.size() > expected.back().hit.rank + 1u;
        }
        move_some();
    }
    EXPECT_GT(count, 500u);
    EXPECT_GT(ties, 20u);
}

TEST_P(WorldHitShapesTest, ABodyThatIsCastMeetsTheFirstOfAll) {
    side = 32;
    fill(200);
    int met = 0;
    for (int frame = 0; frame < 200; ++frame) {
        const BodyId own = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        const Vec3 motion = any_motion();
        const double max_time = std::array{0.0, 0.25, 1.0, 3.0}[random.below(4)];
        std::optional<BodyContact> expected, of_shape;
        for (const BodyId body : bodies) {
            const auto contact = test.cast(posed(own), motion, posed(body), std::min(max_time, 1.0), memory);
            if (!contact) continue;
            if (may_meet(own, body) && (!expected || contact->time < expected->contact.time)) {
                expected = BodyContact{body, *contact};
            }
            const bool is_asked = world.filter(body).groups == 2;
            if (is_asked && (!of_shape || contact->time < of_shape->contact.time)) {
                of_shape = BodyContact{body, *contact};
            }
        }
        ASSERT_EQ(world.cast(own, motion, max_time), expected);
        ASSERT_EQ(world.cast(own, motion, max_time, memory), expected);
        const auto shape = world.shape(own);
        ASSERT_EQ(world.cast({{*shape, world.pose(own)}, CollisionFilter{.mask = 2}}, motion, max_time), of_shape);
        ASSERT_EQ(world.cast({{*shape, world.pose(own)}, CollisionFilter{.mask = 2}}, motion, max_time, memory),
                  of_shape);
        met += expected && expected->contact.time > 0;
        move_some();
    }
    EXPECT_GT(met, 10);
}

TEST_P(WorldHitShapesTest, MeetingsAreThoseOfAllPairsInOrder) {
    side = 20;
    fill(120);
    std::size_t met = 0, at_start = 0;
    for (int frame = 0; frame < 20; ++frame) {
        // Few, many, all; some of them twice.
        std::vector<BodyId> moved;
        std::vector<Pose> poses;
        const std::uint32_t one_in = std::array{40u, 3u, 1u}[frame % 3];
        for (int pass = 0; pass < 2; ++pass) {
            for (const BodyId body : bodies) {
                if (random.below(pass == 0 ? one_in : 30) != 0) continue;
                Pose pose = world.pose(body);
                if (random.below(5) != 0) pose.t += any_motion();
                moved.push_back(body);
                poses.push_back(pose);
            }
        }
        const auto way_of = [&](BodyId body) {
            Pose to = world.pose(body);
            for (std::size_t i = 0; i < moved.size(); ++i) {
                if (moved[i] == body) to = poses[i];
            }
            kept.push_back(world.shape(body));
            return Moving<Shape>(*kept.back(), world.pose(body), to);
        };
        std::vector<Meeting> expected;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                if (!may_meet(bodies[i], bodies[j])) continue;
                const auto contact = test.cast_moving(way_of(bodies[i]), way_of(bodies[j]), 1, memory);
                if (contact) expected.push_back({{bodies[i], bodies[j]}, *contact});
            }
        }
        std::ranges::stable_sort(expected, {}, [](const Meeting& m) { return m.contact.time; });
        const std::uint64_t digest = world.digest();
        ASSERT_EQ(world.meetings(moved, poses), expected) << frame;
        ASSERT_EQ(world.meetings(moved, poses, memory), expected) << frame;
        ASSERT_EQ(world.digest(), digest) << "it moves nothing";
        met += expected.size();
        at_start += std::ranges::count(expected, 0.0, [](const Meeting& m) { return m.contact.time; });
        // Before any update, after one, and with changes since.
        if (frame % 4 == 1) world.update();
        if (frame % 4 == 2) move_some();
        if (frame % 8 == 3) {
            world.destroy_body(bodies[7]);
            bodies.erase(bodies.begin() + 7);
            bodies.push_back(world.create_body(shapes[2], any_pose()));
            std::ranges::sort(bodies);
        }
        if (frame % 8 == 6) world.set_filter(bodies[3], {.groups = 2, .mask = 1});
        kept.clear();
    }
    EXPECT_GT(at_start, 200u);
    EXPECT_GT(met, at_start + 200);
}

// A test that is registered for the kinds in the other order is asked so, and its answer turned round.
TEST_P(WorldHitShapesTest, TheCastBodyIsAWhateverTheTestIsRegisteredFor) {
    const BodyId mesh = world.create_body(scenes::cube(0.25), at(0));
    const BodyId slab = world.create_body(shapes[2], at(10, 0.5));
    const auto of_mesh = world.cast(mesh, Vec3(16, 0, 0));
    ASSERT_TRUE(of_mesh);
    EXPECT_EQ(of_mesh->body, slab);
    EXPECT_EQ(of_mesh->contact.time, 8.75 / 16);
    EXPECT_EQ(of_mesh->contact.a.triangle, 1u);
    EXPECT_EQ(of_mesh->contact.b.triangle, 4u);
    const auto of_slab = world.cast(slab, Vec3(-16, 0, 0));
    ASSERT_TRUE(of_slab);
    EXPECT_EQ(of_slab->body, mesh);
    EXPECT_EQ(of_slab->contact.time, 8.75 / 16);
    EXPECT_EQ(of_slab->contact.a.triangle, 4u);
    EXPECT_EQ(world.cast(slab, Vec3(16, 0, 0)), std::nullopt);
    const auto meetings = world.meetings({&slab, 1}, std::vector{at(-6, 0.5)});
    ASSERT_EQ(meetings.size(), 1u);
    EXPECT_EQ(meetings[0].bodies, (BodyPair{mesh, slab}));
    EXPECT_EQ(meetings[0].contact, of_mesh->contact);
}

TEST_P(WorldHitShapesTest, WhatIsNotAnsweredIsRefusedBeforeAnyBodyIsAsked) {
    const BodyId a = world.create_body(shapes[0], at(0));
    const Segment far{Vec3(100, 0, 0), Vec3(101, 0, 0)};
    EXPECT_TRUE(world.all_hits(far).empty());
    const BodyId silent = world.create_body(std::make_shared<SlabShape>(0.5, false), at(50));
    expect_not_supported([&] { std::ignore = world.all_hits(far); }, Question::hits, slab_kind, slab_kind);
    expect_not_supported([&] { std::ignore = world.first_hit(Ray{}); }, Question::hits, slab_kind, slab_kind);
    world.destroy_body(silent);
    EXPECT_TRUE(world.all_hits(far).empty());
    const BodyId other = world.create_body(std::make_shared<SlabShape>(0.5, false), at(50));
    world.set_shape(other, shapes[0]);
    EXPECT_TRUE(world.all_hits(far).empty());

    EXPECT_EQ(world.cast(a, Vec3(1, 0, 0)), std::nullopt);
    world.set_test(slab_kind, slab_kind, std::make_shared<SlabTest>(false));
    expect_not_supported([&] { std::ignore = world.cast(a, Vec3(1, 0, 0)); }, Question::cast, slab_kind, slab_kind);
    expect_not_supported(
        [&] {
            std::ignore = world.cast({*shapes[0], at(-9)}, Vec3(1, 0, 0));
        },
        Question::cast, slab_kind, slab_kind);
    expect_not_supported([&] { std::ignore = world.meetings({}, std::span<const Pose>()); }, Question::cast_moving,
                         slab_kind, slab_kind);
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>(false));
    expect_not_supported(
        [&] {
            std::ignore = world.cast({scenes::cube(1), at(-9)}, Vec3(1, 0, 0));
        },
        Question::cast, slab_kind, ShapeKind::mesh());
}

// A shape may ask the library in the memory that it is given, as a rounded one does: the first hit so far is kept.
TEST_P(WorldHitShapesTest, ShapesThatAskInTheSameMemory) {
    const auto plate = scenes::one_triangle({Vec3(0, -9, -9), Vec3(10, 9, -9), Vec3(10, 9, 20)});
    world.create_body(plate, Pose());  // its box is met before that of the next body, its triangle after it
    const BodyId near = world.create_body(rounded(std::make_shared<const MeshShape>(cube), 0), at(2));
    const auto hit = world.first_hit(Ray{Vec3(-5, 0, 0), Vec3(1, 0, 0)});  // at a diagonal of a side
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, near);
    EXPECT_EQ(hit->hit.parameter, 6.5);
}

}  // namespace
}  // namespace ecods::world_hit_shapes_test
