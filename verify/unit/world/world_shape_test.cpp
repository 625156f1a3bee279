// Shapes of the caller's own beside meshes.

#include <gtest/gtest.h>

#include <stdexcept>
#include <tuple>

#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_shape_test {
namespace {

constexpr ShapeKind plane_kind{1};
constexpr ShapeKind point_kind{2};

// The half space below z = height, whatever its pose.
class HalfSpace final : public Shape {
  public:
    explicit HalfSpace(double height) : height_(height) {}
    ShapeKind kind() const noexcept override { return plane_kind; }
    Aabb box(const Pose&) const override {
        const double infinity = std::numeric_limits<double>::infinity();
        return {Vec3::Constant(-infinity), Vec3(infinity, infinity, height_)};
    }
    std::uint64_t digest() const noexcept override { return 17; }
    double height() const { return height_; }

  private:
    double height_;
};

// One point, at the pose's translation.
class PointShape final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return point_kind; }
    Aabb box(const Pose& pose) const override { return {pose.t, pose.t}; }
    std::uint64_t digest() const noexcept override { return 18; }
};

// Registered with the half space first; meshes must be posed by translation only.
class HalfSpaceMeshTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& plane, const Posed<Shape>& mesh, const Ask&) const override {
        if (fails) throw std::runtime_error("a test that fails");
        ++calls;
        const double height = dynamic_cast<const HalfSpace&>(*plane.what).height();
        for (const Vec3& v : dynamic_cast<const MeshShape&>(*mesh.what).mesh().vertices()) {
            if (v.z() + mesh.pose.t.z() <= height) return true;
        }
        return false;
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return intersects(a, b, ask) ? Relation::touching : Relation::apart;
    }

    bool fails = false;
    mutable int calls = 0;
};

class HalfSpacePointTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& plane, const Posed<Shape>& point, const Ask&) const override {
        return point.pose.t.z() <= dynamic_cast<const HalfSpace&>(*plane.what).height();
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return intersects(a, b, ask) ? Relation::crossing : Relation::apart;
    }
};

class WorldShapeTest : public EachWorld {
  protected:
    std::shared_ptr<HalfSpaceMeshTest> plane_mesh = std::make_shared<HalfSpaceMeshTest>();
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldShapeTest, broad_phases(), broad_phase_name);

TEST_P(WorldShapeTest, AHalfSpaceAmongMeshes) {
    world.set_test(plane_kind, ShapeKind::mesh(), plane_mesh);
    // The mesh has the smaller id here, and the larger one below: the test gets its arguments in its own order.
    const BodyId first = world.create_body(cube, at(0, 0, 0.5));
    const BodyId plane = world.create_body(std::make_shared<HalfSpace>(0), Pose());
    const BodyId above = world.create_body(cube, at(9, 0, 0.75));
    const BodyId second = world.create_body(cube, at(0.5, 0.5, 0.25));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{first, plane}, {first, second}, {plane, second}}));
    EXPECT_EQ(world.relation(plane, first), Relation::touching);
    EXPECT_EQ(world.relation(first, plane), Relation::touching);
    EXPECT_EQ(world.relation(plane, above), Relation::apart);
    EXPECT_THROW(static_cast<void>(world.intersecting_triangles(plane, first)), NotSupported);
    world.check_invariants();

    // A second half space has no test against the first.
    EXPECT_INVALID(world.create_body(std::make_shared<HalfSpace>(1), Pose()), Question::intersects);
    // But the one that is there may be exchanged.
    world.set_shape(plane, std::make_shared<HalfSpace>(-1));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{first, second}}));
    world.check_invariants();
}

// A test that answers nothing but whether there is a contact.
class ContactOnly final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return true; }
};

TEST_P(WorldShapeTest, AQuestionThatATestDoesNotAnswerIsNamed) {
    world.set_test(plane_kind, ShapeKind::mesh(), std::make_shared<ContactOnly>());
    const BodyId mesh = world.create_body(cube, at(0));
    const BodyId plane = world.create_body(std::make_shared<HalfSpace>(0), Pose());
    EXPECT_TRUE(world.intersects(mesh, plane));
    expect_not_supported([&] { std::ignore = world.relation(mesh, plane); }, Question::relation, plane_kind,
                         ShapeKind::mesh());
    expect_not_supported([&] { std::ignore = world.intersecting_triangles(mesh, plane); },
                         Question::intersecting_triangles, plane_kind, ShapeKind::mesh());
}

// The verdicts are found again, and nobody has moved.
TEST_P(WorldShapeTest, AnotherTestIsNoMotion) {
    world.set_test(plane_kind, ShapeKind::mesh(), plane_mesh);
    world.create_body(cube, at(0, 0, 0.75));
    world.create_body(std::make_shared<HalfSpace>(0.5), Pose());
    world.update();
    EXPECT_EQ(world.statistics().moved_bodies, 2u);
    EXPECT_EQ(world.colliding_pairs().size(), 1u);
    world.set_test(plane_kind, ShapeKind::mesh(), std::make_shared<HalfSpaceMeshTest>());
    world.update();
    EXPECT_EQ(world.statistics().moved_bodies, 2u);
    EXPECT_EQ(world.statistics().two_body_tests, 2u);
    world.check_invariants();
}

TEST_P(WorldShapeTest, KindsThatAreGoneNeedNoTest) {
    world.set_test(plane_kind, point_kind, std::make_shared<HalfSpacePointTest>());
    const BodyId plane = world.create_body(std::make_shared<HalfSpace>(0), Pose());
    const BodyId point = world.create_body(std::make_shared<PointShape>(), at(1, 2, 0));
    EXPECT_INVALID(world.create_body(cube, Pose()), Question::intersects);
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{plane, point}}));
    EXPECT_EQ(world.relation(point, plane), Relation::crossing);
    world.destroy_body(plane);
    world.destroy_body(point);
    EXPECT_NO_THROW(world.create_body(cube, Pose()));
    world.update();
    world.check_invariants();
}

TEST_P(WorldShapeTest, ATestThatThrowsLeavesTheListsAndIsAskedAgain) {
    world.set_test(plane_kind, ShapeKind::mesh(), plane_mesh);
    const BodyId body = world.create_body(cube, at(0, 0, 3));
    const BodyId plane = world.create_body(std::make_shared<HalfSpace>(0), Pose());
    const BodyId other = world.create_body(cube, at(0.5, 0.5, 3.5));
    world.update();
    const auto before = list(world.colliding_pairs());
    ASSERT_EQ(before, (std::vector<BodyPair>{{body, other}}));

    plane_mesh->fails = true;
    world.set_pose(body, at(0, 0, 0.25));
    EXPECT_THROW(world.update(), std::runtime_error);
    EXPECT_EQ(list(world.colliding_pairs()), before);
    world.set_pose(other, at(0.5, 0.5, -1));
    EXPECT_THROW(world.update(), std::runtime_error);
    EXPECT_EQ(list(world.colliding_pairs()), before);

    plane_mesh->fails = false;
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{body, plane}, {plane, other}}));
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{body, other}}));
    EXPECT_EQ(list(world.began()), list(world.colliding_pairs()));
    world.check_invariants();
}

TEST_P(WorldShapeTest, APairThatPartsAndMeetsWhileUpdatesFailGoesOn) {
    world.set_test(plane_kind, ShapeKind::mesh(), plane_mesh);
    const BodyId body = world.create_body(cube, at(0, 0, 3));
    world.create_body(std::make_shared<HalfSpace>(0), Pose());
    const BodyId other = world.create_body(cube, at(0.5, 0.5, 3.5));
    world.create_body(cube, at(50, 0, -3));
    world.update();
    const auto before = list(world.colliding_pairs());

    plane_mesh->fails = true;
    world.set_pose(body, at(100, 0, -1));
    EXPECT_THROW(world.update(), std::runtime_error);
    plane_mesh->fails = false;
    world.set_pose(body, at(0, 0, 3));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), before);
    EXPECT_TRUE(world.began().empty());
    EXPECT_TRUE(world.ended().empty());
    EXPECT_TRUE(world.intersects(body, other));
    world.check_invariants();
}

TEST_P(WorldShapeTest, AReplacedTestIsAskedAnew) {
    class Never final : public TwoBodyTest {
      public:
        bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return false; }
        Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
            return Relation::apart;
        }
    };
    world.create_body(cube, at(0));
    world.create_body(cube, at(0.5, 0.5, 0.5));
    world.update();
    ASSERT_EQ(world.colliding_pairs().size(), 1u);
    world.set_test(ShapeKind::mesh(), ShapeKind::mesh(), std::make_shared<Never>());
    world.update();
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_EQ(world.ended().size(), 1u);
}

// A shape that breaks its promise to be immutable.
class Growing final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return point_kind; }
    Aabb box(const Pose&) const override { return {Vec3::Zero(), Vec3::Constant(size)}; }
    std::uint64_t digest() const noexcept override { return name; }

    double size = 1;
    std::uint64_t name = 1;
};

TEST_P(WorldShapeTest, AShapeThatChangedUnderItsBodyIsFound) {
    const auto shape = std::make_shared<Growing>();
    const BodyId body = world.create_body(shape, Pose());
    world.update();
    EXPECT_NO_THROW(world.check_invariants());
    shape->size = 2;
    try {
        world.check_invariants();
        ADD_FAILURE();
    } catch (const ShapeChanged& error) {
        EXPECT_EQ(error.body, body);
        EXPECT_EQ(error.kind, point_kind);
        EXPECT_NE(std::string(error.what()).find("box"), std::string::npos) << error.what();
    }
    shape->size = 1;
    shape->name = 2;
    EXPECT_THROW(world.check_invariants(), ShapeChanged);
    world.set_shape(body, std::make_shared<Growing>(*shape));
    world.update();
    EXPECT_NO_THROW(world.check_invariants());
}

}  // namespace
}  // namespace ecods::world_shape_test
