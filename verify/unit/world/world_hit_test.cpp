// What a segment or a ray meets of the meshes of a world: what asking all bodies one by one says, in the exact order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/slab_shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_hit_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

auto fields(const BodyHit& h) {
    return std::tuple(h.body, h.hit.parameter, h.hit.leave_parameter, h.hit.kind, h.hit.rank, h.hit.feature.kind,
                      h.hit.feature.triangle, h.hit.feature.corner);
}

// A triangle across the x axis at this x, seen from below.
std::shared_ptr<const Mesh> wall(double x) {
    return Mesh::create({Vec3(x, -1, -1), Vec3(x, 3, -1), Vec3(x, -1, 3)}, {{0, 1, 2}});
}

class WorldHitTest : public EachWorld {
  protected:
    template <class Line>
    std::vector<BodyHit> model_of_all_hits(const Line& line, const std::optional<CollisionFilter>& filter) {
        std::vector<BodyHit> hits;
        for (const BodyId body : world.bodies()) {
            if (filter && !may_meet(*filter, world.filter(body))) continue;
            const auto shape = world.shape(body);
            const Posed<MeshShape> posed(dynamic_cast<const MeshShape&>(*shape), world.pose(body));
            for (const Hit& hit : ecods::all_hits(line, posed, memory)) hits.push_back({body, hit});
        }
        std::ranges::stable_sort(hits, {}, [](const BodyHit& h) { return h.hit.parameter; });
        rank_by_parameter(hits);
        return hits;
    }
    template <class Line>
    void require_as_model(const Line& line, const std::optional<CollisionFilter>& filter) {
        const auto expected = model_of_all_hits(line, filter);
        const auto got = world.all_hits(line, filter);
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) ASSERT_EQ(fields(got[i]), fields(expected[i])) << i;
        for (const auto& first : {world.first_hit(line, filter), world.first_hit(line, filter, memory)}) {
            ASSERT_EQ(first.has_value(), !expected.empty());
            if (first) {
                ASSERT_EQ(fields(*first), fields(expected[0]));
            }
        }
        count += expected.size();
    }

    scenes::Random random{29};
    std::size_t count = 0;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldHitTest, broad_phases(), broad_phase_name);

// Cubes on a lattice, many of them in one place, hit along axes and diagonals: with motions of powers of two all
// parameters are doubles.
TEST_P(WorldHitTest, HitsAreThoseOfAllBodiesInOrder) {
    const std::array meshes = {scenes::cube(0.5), scenes::cube(0.25), scenes::cube(1)};
    const auto any_pose = [&] { return at(random.below(10), random.below(10), random.below(3)); };
    std::vector<BodyId> bodies;
    for (int i = 0; i < 150; ++i) {
        bodies.push_back(world.create_body(meshes[random.below(3)], any_pose()));
        if (random.below(4) == 0) world.set_filter(bodies.back(), {.groups = 2});
    }
    constexpr std::array steps = {-16.0, 0.0, 0.0, 16.0};
    for (int frame = 0; frame < 30; ++frame) {
        const Vec3 from = any_pose().t + Vec3::Constant(0.25 * random.below(3));
        Vec3 step(steps[random.below(4)], steps[random.below(4)], steps[random.below(4)]);
        std::optional<CollisionFilter> filter;
        if (random.below(2) == 0) filter = CollisionFilter{.mask = 2};
        ASSERT_NO_FATAL_FAILURE(require_as_model(Segment{from, from + step}, filter));
        if (step == Vec3::Zero()) step = Vec3::UnitZ();
        const double max_parameter = std::array{0.0, 0.25, 1.0, infinity}[random.below(4)];
        ASSERT_NO_FATAL_FAILURE(require_as_model(Ray{from, step, max_parameter}, filter));
        for (int i = 0; i < 20; ++i) world.set_pose(bodies[random.below(150)], any_pose());
    }
    EXPECT_GT(count, 400u);
}

// Parameters that round to one double are ordered as they are; exact ties by id.
TEST_P(WorldHitTest, TheOrderIsThatOfTheRealParameters) {
    const Segment segment{Vec3(0, 0, 0), Vec3(3, 0, 0)};
    const double x = 1 + 0x1p-52;
    const BodyId late = world.create_body(wall(std::nextafter(x, 2)), at(0));
    const BodyId second = world.create_body(wall(x), at(0));
    const BodyId first = world.create_body(wall(1), at(0));
    const BodyId tie = world.create_body(wall(x - 0.25), at(0.25));
    const auto hits = world.all_hits(segment);
    ASSERT_EQ(hits.size(), 4u);
    const std::array expected = {first, second, tie, late};
    const std::array<std::uint32_t, 4> ranks = {0, 1, 1, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(hits[i].body, expected[i]) << i;
        EXPECT_EQ(hits[i].hit.rank, ranks[i]) << i;
    }
    EXPECT_EQ(world.first_hit(segment)->body, first);
    world.destroy_body(first);
    EXPECT_EQ(world.first_hit(segment)->body, second);
    world.destroy_body(second);
    EXPECT_EQ(world.first_hit(segment)->body, tie);
    world.destroy_body(tie);
    EXPECT_EQ(world.first_hit(segment)->body, late);
}

// The same among many bodies, in all orders of creation, and where the boxes say nothing.
TEST_P(WorldHitTest, NeighbouringWallsAreHitInOrder) {
    for (int round = 0; round < 20; ++round) {
        World many{WorldOptions{GetParam()}};
        std::vector<double> places(100);
        double x = 1;
        for (double& place : places) {
            place = x;
            if (random.below(3) != 0) x = std::nextafter(x, 2);
        }
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1], places[random.below(static_cast<std::uint32_t>(i))]);
        }
        for (const double place : places) many.create_body(wall(place), at(0));
        const auto bodies = many.bodies();
        std::vector<std::size_t> order(places.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i]; });
        const Ray ray{Vec3(0, 0.25, 0.25), Vec3(random.uniform(1, 4096), 0, 0)};
        const auto hits = many.all_hits(ray, {}, memory);
        ASSERT_EQ(hits.size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(hits[i].body, bodies[order[i]]);
        ASSERT_EQ(many.first_hit(ray, {}, memory)->body, bodies[order[0]]);
    }
}

// Parameters of shapes of the caller's own are what they are, beside real ones of meshes.
TEST_P(WorldHitTest, ShapesOfTheCallersOwnAreInTheSameOrder) {
    world.set_test(slab_kind, slab_kind, std::make_shared<SlabTest>());
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    const auto slab = std::make_shared<SlabShape>(1);
    const BodyId a = world.create_body(slab, at(2));
    const BodyId b = world.create_body(wall(1), at(0));
    const BodyId c = world.create_body(slab, at(2));
    const BodyId d = world.create_body(wall(std::nextafter(1, 0)), at(0));
    // 1/3 rounded is below the real parameter of the wall that is met there, whose rounded one it is, too.
    for (const double length : {4.0, 3.0}) {
        const Segment segment{Vec3(0, 0.25, 0.25), Vec3(length, 0.25, 0.25)};
        const bool is_rounded = length == 3;
        const auto hits = world.all_hits(segment);
        ASSERT_EQ(hits.size(), 6u);
        const std::array expected = {d, a, is_rounded ? c : b, is_rounded ? b : c, a, c};
        const std::array<std::uint32_t, 6> ranks = {
            0, 1, 1, is_rounded ? 2u : 1u, is_rounded ? 3u : 2u, is_rounded ? 3u : 2u};
        for (std::size_t i = 0; i < hits.size(); ++i) {
            EXPECT_EQ(hits[i].body, expected[i]) << i;
            EXPECT_EQ(hits[i].hit.rank, ranks[i]) << i;
        }
        EXPECT_EQ(hits[1].hit.parameter, hits[3].hit.parameter);
    }
    EXPECT_EQ(world.first_hit(Ray{Vec3(0, 0.25, 0.25), Vec3(4, 0, 0)})->body, d);
    world.destroy_body(d);
    EXPECT_EQ(world.first_hit(Ray{Vec3(0, 0.25, 0.25), Vec3(4, 0, 0)})->body, a);
}

TEST_P(WorldHitTest, BadArgumentsAreRefused) {
    world.create_body(wall(1), at(0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_INVALID(world.first_hit(Segment{Vec3(0, nan, 0), Vec3(0, 0, 0)}), Argument::segment);
    EXPECT_INVALID(world.all_hits(Segment{Vec3(0, 0, 0), Vec3(0, 0, infinity)}), Argument::segment);
    EXPECT_INVALID(world.first_hit(Ray{Vec3(0, 0, 0), Vec3(0, 0, 0)}), Argument::ray);
    EXPECT_INVALID(world.all_hits(Ray{.max_parameter = nan}), Argument::ray);
    EXPECT_EQ(world.all_hits(Ray{.max_parameter = 0.5}).size(), 0u);
    EXPECT_FALSE(World().first_hit(Ray{}).has_value());
}

}  // namespace
}  // namespace ecods::world_hit_test
