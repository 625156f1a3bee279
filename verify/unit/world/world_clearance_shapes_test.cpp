// Distances of shapes of the caller's own: a test answers what it says it answers, and where it does not, no list is
// made without it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_clearance_shapes_test {
namespace {

constexpr ShapeKind point_kind{2};

class PointShape final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return point_kind; }
    Aabb box(const Pose& pose) const override { return {pose.t, pose.t}; }
    std::uint64_t digest() const noexcept override { return 18; }
};

// Of points on the x axis, and of cubes around it. Registered with the point first.
class PointTest : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return distance(a, b, ask) == 0;
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& /*ask*/) const override {
        EXPECT_EQ(a.what->kind(), point_kind);
        const double half = b.what->kind() == ShapeKind::mesh() ? 0.5 : 0;
        return std::max(0.0, std::abs(a.pose.t[0] - b.pose.t[0]) - half);
    }
};

class AnsweringPointTest final : public PointTest {
  public:
    bool answers(Question question) const noexcept override {
        return question == Question::distance || question == Question::within || question == Question::closest;
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, const Ask& ask) const override {
        return distance(a, b, ask) <= d;
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        ClosestPoints points;
        points.distance = distance(a, b, ask);
        points.point_a = a.pose.t;
        points.point_b = b.pose.t;
        return points;
    }
};

class WorldClearanceShapesTest : public EachWorld {
  protected:
    WorldClearanceShapesTest() {
        world.set_test(point_kind, ShapeKind::mesh(), answering);
        world.set_test(point_kind, point_kind, answering);
    }

    template <class Call>
    void expect_not_supported(const Call& call, Question question, ShapeKind a, ShapeKind b) {
        const std::uint64_t digest = world.digest();
        ecods::expect_not_supported(call, question, a, b);
        EXPECT_EQ(world.digest(), digest);
    }

    std::shared_ptr<const Shape> point = std::make_shared<PointShape>();
    std::shared_ptr<const TwoBodyTest> answering = std::make_shared<AnsweringPointTest>();
    std::shared_ptr<const TwoBodyTest> silent = std::make_shared<PointTest>();
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldClearanceShapesTest, broad_phases(), broad_phase_name);

TEST_P(WorldClearanceShapesTest, TheyAreAskedAsMeshesAre) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId p = world.create_body(point, at(1));
    const BodyId q = world.create_body(point, at(3));
    world.set_clearance(0.5);
    world.update();
    EXPECT_EQ(list(world.close_pairs()), (std::vector<BodyPair>{{a, p}}));
    EXPECT_EQ(world.distance(a, q), 2.5);
    EXPECT_EQ(world.distance(q, a), 2.5);
    EXPECT_TRUE(world.within(q, p, 2));
    EXPECT_EQ(world.closest(a, p).point_b, Vec3(1, 0, 0));
    EXPECT_EQ(world.closest(p, a).point_a, Vec3(1, 0, 0));
    EXPECT_EQ(world.nearest(q), (NearestBody{p, 2}));
    EXPECT_EQ(world.nearest(a), (NearestBody{p, 0.5}));
    EXPECT_EQ(world.nearest({*point, at(2)}), (NearestBody{p, 1}));
    EXPECT_EQ(world.closest_pair(), (ClosestPair{{a, p}, 0.5, world.closest(a, p)}));
    EXPECT_EQ(world.closest_pairs(0.5), (std::vector<ClosestPair>{{{a, p}, 0.5, world.closest(a, p)}}));
    world.check_invariants();
}

TEST_P(WorldClearanceShapesTest, TheCallThatMakesAListPossibleIsRefused) {
    world.set_test(point_kind, ShapeKind::mesh(), silent);
    world.create_body(cube, at(0));
    const BodyId far = world.create_body(cube, at(1000));
    const BodyId p = world.create_body(point, at(2));
    world.update();
    expect_not_supported([&] { world.set_clearance(0.5); }, Question::within, point_kind, ShapeKind::mesh());
    EXPECT_EQ(world.clearance(), std::nullopt);
    expect_not_supported([&] { std::ignore = world.nearest(far); }, Question::within, point_kind, ShapeKind::mesh());
    expect_not_supported(
        [&] {
            std::ignore = world.nearest({*point, at(999)});
        },
        Question::within, point_kind, ShapeKind::mesh());
    expect_not_supported([&] { std::ignore = world.closest_pair(); }, Question::within, point_kind, ShapeKind::mesh());
    EXPECT_EQ(world.distance(far, p), 997.5) << "a question about a pair is the test's to answer";
    expect_not_supported([&] { std::ignore = world.closest(far, p); }, Question::closest, point_kind,
                         ShapeKind::mesh());
    expect_not_supported([&] { std::ignore = world.within(far, p, 1); }, Question::within, point_kind,
                         ShapeKind::mesh());
}

TEST_P(WorldClearanceShapesTest, SoIsTheCallThatBringsAKindIn) {
    world.set_test(point_kind, ShapeKind::mesh(), silent);
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(2));
    world.set_clearance(0.5);
    expect_not_supported([&] { world.create_body(point, at(9)); }, Question::within, point_kind, ShapeKind::mesh());
    expect_not_supported([&] { world.set_shape(a, point); }, Question::within, point_kind, ShapeKind::mesh());
    EXPECT_EQ(world.bodies().size(), 2u);
    // Where the test answers, or no such pair is left, it may come.
    world.set_test(point_kind, ShapeKind::mesh(), answering);
    const BodyId p = world.create_body(point, at(1));
    expect_not_supported([&] { world.set_test(ShapeKind::mesh(), point_kind, silent); }, Question::within,
                         ShapeKind::mesh(), point_kind);
    world.update();
    EXPECT_EQ(list(world.close_pairs()), (std::vector<BodyPair>{{a, p}, {b, p}}));
    world.set_test(point_kind, point_kind, silent);  // of points there is one
    world.destroy_body(p);
    world.set_test(point_kind, ShapeKind::mesh(), silent);
    world.set_clearance({});
    world.create_body(point, at(1));
    world.update();
    world.check_invariants();
}

}  // namespace
}  // namespace ecods::world_clearance_shapes_test
