// Sides of hits, and parts of lines inside bodies, in a world: what asking all bodies one by one says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_hit_sides_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

auto fields(const BodySidedHit& h) {
    const SidedHit& s = h.sided;
    return std::tuple(h.body, s.hit.parameter, s.hit.leave_parameter, s.hit.kind, s.hit.rank, s.hit.feature.triangle,
                      s.before, s.after, s.passage, s.normal);
}

class WorldHitSidesTest : public EachWorld {
  protected:
    template <class Line>
    std::vector<BodySidedHit> model_of_sides(const Line& line, const World::Filter& filter) {
        std::vector<BodySidedHit> hits;
        for (const BodyId body : world.bodies()) {
            if (filter && !may_meet(*filter, world.filter(body))) continue;
            const auto shape = std::dynamic_pointer_cast<const MeshShape>(world.shape(body));
            for (const SidedHit& hit : sided_hits(line, {shape, world.pose(body)})) hits.push_back({body, hit});
        }
        const auto parameter = [](const BodySidedHit& h) { return h.sided.hit.parameter; };
        std::ranges::stable_sort(hits, {}, parameter);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            std::uint32_t& rank = hits[i].sided.hit.rank;
            rank = i == 0 ? 0 : hits[i - 1].sided.hit.rank + (parameter(hits[i]) != parameter(hits[i - 1]));
        }
        return hits;
    }
    template <class Line>
    std::vector<BodyInsidePart> model_of_parts(const Line& line, const World::Filter& filter) {
        std::vector<BodyInsidePart> parts;
        for (const BodyId body : world.bodies()) {
            if (filter && !may_meet(*filter, world.filter(body))) continue;
            const auto solid = std::dynamic_pointer_cast<const Solid>(world.shape(body));
            if (!solid) continue;
            for (const InsidePart& part : inside_parts(line, {solid, world.pose(body)})) parts.push_back({body, part});
        }
        std::ranges::stable_sort(parts, {}, [](const BodyInsidePart& p) { return p.part.from; });
        return parts;
    }
    template <class Line>
    void require_as_model(const Line& line, const World::Filter& filter) {
        const auto expected = model_of_sides(line, filter), got = world.sided_hits(line, filter);
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) ASSERT_EQ(fields(got[i]), fields(expected[i])) << i;
        const auto parts = model_of_parts(line, filter);
        ASSERT_EQ(world.inside_parts(line, filter), parts);
        ASSERT_EQ(world.inside_parts(line, filter, memory), parts);
        hit_count += got.size();
        part_count += parts.size();
    }

    scenes::Random random{43};
    std::size_t hit_count = 0, part_count = 0;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldHitSidesTest, broad_phases(), broad_phase_name);

// Cubes, solids and surfaces, on a lattice, many of them in one place, hit along axes and diagonals from inside and
// outside. With motions of powers of two all parameters are doubles.
TEST_P(WorldHitSidesTest, AreThoseOfAllBodiesInOrder) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (const double half : {0.5, 0.25, 1.0}) {
        shapes.push_back(std::make_shared<const Solid>(scenes::cube(half)));
        shapes.push_back(std::make_shared<const ConvexSolid>(scenes::cube(half)));
        shapes.push_back(std::make_shared<const MeshShape>(scenes::cube(half)));
    }
    const auto any_pose = [&] { return at(random.below(6), random.below(6), random.below(3)); };
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) {
        bodies.push_back(world.create_body(shapes[random.below(9)], any_pose()));
        if (random.below(4) == 0) world.set_filter(bodies.back(), {.groups = 2});
    }
    constexpr std::array steps = {-16.0, 0.0, 0.0, 16.0};
    for (int frame = 0; frame < 50; ++frame) {
        const Vec3 from = any_pose().t + Vec3::Constant(0.125 * random.below(3));
        Vec3 step(steps[random.below(4)], steps[random.below(4)], steps[random.below(4)]);
        World::Filter filter;
        if (random.below(2) == 0) filter = CollisionFilter{.mask = 2};
        ASSERT_NO_FATAL_FAILURE(require_as_model(Segment{from, from + step}, filter));
        if (step == Vec3::Zero()) step = Vec3::UnitZ();
        const double max_parameter = std::array{0.0, 0.25, 1.0, infinity}[random.below(4)];
        ASSERT_NO_FATAL_FAILURE(require_as_model(Ray{from, step, max_parameter}, filter));
        for (int i = 0; i < 9; ++i) world.set_pose(bodies[random.below(60)], any_pose());
    }
    EXPECT_GT(hit_count, 400u);
    EXPECT_GT(part_count, 60u);
}

// A line through a box inside a box: it comes into the outer one first, whatever the ids are.
TEST_P(WorldHitSidesTest, KnownSides) {
    const BodyId inner = world.create_body(std::make_shared<const Solid>(scenes::cube(0.5)), Pose());
    const BodyId outer = world.create_body(std::make_shared<const Solid>(scenes::cube(1)), Pose());
    const Segment line{Vec3(-2, 0.25, 0.125), Vec3(2, 0.25, 0.125)};
    const auto hits = world.sided_hits(line);
    ASSERT_EQ(hits.size(), 4u);
    const std::array bodies = {outer, inner, inner, outer};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(hits[i].body, bodies[i]);
        EXPECT_EQ(hits[i].sided.hit.rank, i);
        EXPECT_EQ(hits[i].sided.passage, i < 2 ? Passage::enters : Passage::leaves);
        EXPECT_EQ(hits[i].sided.normal, Vec3(i < 2 ? -1 : 1, 0, 0));
    }
    const auto parts = world.inside_parts(line);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].body, outer);
    EXPECT_EQ(parts[0].part.from, 0.25);
    EXPECT_EQ(parts[1].body, inner);
    EXPECT_EQ(parts[1].part.to, 0.625);
    EXPECT_EQ(world.inside_parts(Ray{Vec3(0, 0, 0), Vec3(1, 0, 0)})[0].body, inner) << "both begin at 0";
    world.set_filter(outer, {.groups = 2, .mask = 2});
    EXPECT_EQ(world.inside_parts(line, CollisionFilter{.groups = 1, .mask = 1}).size(), 1u);
    EXPECT_EQ(world.sided_hits(line, CollisionFilter{.groups = 1, .mask = 1}).size(), 2u);
}

// Parts whose parameters round to one double are ordered as they are.
TEST_P(WorldHitSidesTest, TheOrderIsThatOfTheRealParameters) {
    const auto slab = [](double from) {
        std::vector<Vec3> corners;
        for (const double x : {from, 3.0}) {
            for (const double y : {-1.0, 3.0}) {
                for (const double z : {-1.0, 2.0}) corners.emplace_back(x, y, z);
            }
        }
        return std::make_shared<const ConvexSolid>(corners);
    };
    const double before = 1.875 + 1 * 0x1p-52, x = std::nextafter(before, 2);
    const BodyId late = world.create_body(slab(std::nextafter(x, 2)), Pose());
    const BodyId second = world.create_body(slab(x), Pose());
    const BodyId first = world.create_body(slab(before), Pose());
    const BodyId tie = world.create_body(slab(x - 0.25), at(0.25));
    const auto parts = world.inside_parts(Segment{Vec3(0, 0, 0), Vec3(3.5, 0, 0)});
    ASSERT_EQ(parts.size(), 4u);
    const std::array expected = {first, second, tie, late};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(parts[i].body, expected[i]) << i;
    EXPECT_EQ(parts[0].part.from, parts[1].part.from);
}

TEST_P(WorldHitSidesTest, WhatIsWrongIsRefused) {
    world.create_body(cube, at(0));
    const Segment line{Vec3(-2, 0.25, 0.125), Vec3(2, 0.25, 0.125)};
    EXPECT_EQ(world.sided_hits(line).size(), 2u);
    EXPECT_TRUE(world.inside_parts(line).empty()) << "a surface has no inside";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_INVALID(world.sided_hits(Segment{Vec3(0, nan, 0), Vec3(0, 0, 0)}), Argument::segment);
    EXPECT_INVALID(world.inside_parts(Segment{Vec3(0, 0, 0), Vec3(0, 0, infinity)}), Argument::segment);
    EXPECT_INVALID(world.sided_hits(Ray{Vec3(0, 0, 0), Vec3(0, 0, 0)}), Argument::ray);
    EXPECT_INVALID(world.inside_parts(Ray{.max_parameter = nan}), Argument::ray);
    const BodyId ball = world.create_body(sphere(1), at(100));
    EXPECT_THROW(std::ignore = world.sided_hits(line), NotSupported);
    EXPECT_THROW(std::ignore = world.inside_parts(Ray{}), NotSupported);
    world.destroy_body(ball);
    EXPECT_EQ(world.sided_hits(line).size(), 2u);
    World moved(std::move(world));
    EXPECT_THROW(std::ignore = world.sided_hits(line), MovedFromWorld);
    EXPECT_THROW(std::ignore = world.inside_parts(line), MovedFromWorld);
}

}  // namespace
}  // namespace ecods::world_hit_sides_test
