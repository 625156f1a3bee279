// Bad input gives its typed error, and changes nothing.

#include <gtest/gtest.h>

#include <limits>

#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_error_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class WorldErrorTest : public testing::Test {
  protected:
    WorldErrorTest() {
        world.update();
        before = state();
    }

    struct State {
        std::uint64_t digest;
        std::vector<BodyId> bodies;
        std::vector<BodyPair> colliding, overlapping, began;
        bool operator==(const State&) const = default;
    };
    State state() {
        return {world.digest(), world.bodies(), list(world.colliding_pairs()), list(world.overlapping_pairs()),
                list(world.began())};
    }
    // The world is as before, and goes on as if nothing had been asked of it.
    void TearDown() override {
        EXPECT_EQ(state(), before);
        world.check_invariants();
        world.update();
        before.began.clear();
        EXPECT_EQ(state(), before);
        world.check_invariants();
    }

    World world;
    std::shared_ptr<const Mesh> cube = scenes::cube(0.5);
    BodyId a = world.create_body(cube, at(0));
    BodyId b = world.create_body(cube, at(0.5, 0.5, 0.5));
    State before;
};

TEST_F(WorldErrorTest, PoseThatIsNotFinite) {
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_INVALID(world.create_body(cube, at(bad)), Argument::pose);
        try {
            world.set_pose(b, at(0, 0, bad));
            ADD_FAILURE();
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::pose);
            EXPECT_EQ(error.body, b);
            EXPECT_EQ(error.part, "t(2)");
            EXPECT_NE(std::string(error.what()).find("t(2)"), std::string::npos) << error.what();
        }
        Pose pose;
        pose.R(1, 2) = bad;
        EXPECT_INVALID(world.set_pose(a, pose), Argument::pose);
    }
}

TEST_F(WorldErrorTest, BodyThatIsNotThere) {
    const BodyId unknown{99, 0}, null, other_generation{a.slot, static_cast<std::uint16_t>(a.generation + 1)};
    for (const BodyId bad : {unknown, null, other_generation}) {
        EXPECT_FALSE(world.is_alive(bad));
        EXPECT_THROW(world.destroy_body(bad), StaleBody);
        EXPECT_THROW(world.set_pose(bad, at(0)), StaleBody);
        EXPECT_THROW(world.set_shape(bad, cube), StaleBody);
        EXPECT_THROW(world.pose(bad), StaleBody);
        EXPECT_THROW(world.shape(bad), StaleBody);
        EXPECT_THROW(world.box(bad), StaleBody);
        EXPECT_THROW(static_cast<void>(world.intersects(bad, a)), StaleBody);
        EXPECT_THROW(static_cast<void>(world.relation(a, bad)), StaleBody);
        EXPECT_THROW(static_cast<void>(world.intersecting_triangles(bad, bad)), StaleBody);
    }
}

TEST_F(WorldErrorTest, OneBodyTwice) {
    EXPECT_THROW(static_cast<void>(world.intersects(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.relation(b, b)), SameBody);
    EXPECT_THROW(static_cast<void>(world.intersecting_triangles(a, a)), SameBody);
}

TEST_F(WorldErrorTest, NullMeshShapeOrTest) {
    EXPECT_INVALID(world.create_body(std::shared_ptr<const Mesh>(), at(0)), Argument::null);
    EXPECT_INVALID(world.create_body(std::shared_ptr<const Shape>(), at(0)), Argument::null);
    EXPECT_INVALID(world.set_shape(a, std::shared_ptr<const Mesh>()), Argument::null);
    EXPECT_INVALID(world.set_shape(a, std::shared_ptr<const Shape>()), Argument::null);
    EXPECT_INVALID(world.set_test({1}, {2}, nullptr), Argument::null);
    EXPECT_INVALID(MeshShape(nullptr), Argument::null);
}

// A shape that gives whatever box it was told to.
class BoxShape final : public Shape {
  public:
    BoxShape(ShapeKind kind, const Aabb& box) : kind_(kind), box_(box) {}
    ShapeKind kind() const noexcept override { return kind_; }
    Aabb box(const Pose&) const override { return box_; }
    std::uint64_t digest() const noexcept override { return 1; }

  private:
    ShapeKind kind_;
    Aabb box_;
};

TEST_F(WorldErrorTest, ShapeWithoutATestAgainstMeshes) {
    const auto shape = std::make_shared<BoxShape>(ShapeKind{7}, Aabb{});
    try {
        world.create_body(shape, at(0));
        ADD_FAILURE();
    } catch (const NotSupported& error) {
        EXPECT_EQ(error.question, Question::intersects);
        EXPECT_EQ(error.a.value, 7u);
        EXPECT_EQ(error.b.value, 0u);
    }
    EXPECT_INVALID(world.set_shape(a, shape), Question::intersects);
}

TEST_F(WorldErrorTest, ShapeThatTakesTheKindOfMeshes) {
    EXPECT_THROW(world.create_body(std::make_shared<BoxShape>(ShapeKind::mesh(), Aabb{}), at(0)), NotSupported);
}

class NoTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return false; }
    Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return Relation::apart; }
};

TEST_F(WorldErrorTest, BoxThatIsNoBox) {
    world.set_test(ShapeKind{7}, ShapeKind::mesh(), std::make_shared<NoTest>());
    for (const auto& [min, max] : {std::pair(1.0, 0.0), std::pair(nan, 0.0), std::pair(0.0, nan)}) {
        const auto shape = std::make_shared<BoxShape>(ShapeKind{7}, Aabb{Vec3(0, min, 0), Vec3(0, max, 0)});
        EXPECT_INVALID(world.create_body(shape, at(0)), Argument::box);
        try {
            world.set_shape(a, shape);
            ADD_FAILURE();
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::box);
            EXPECT_EQ(error.part, std::isnan(max) ? "max(1)" : "min(1)");
            EXPECT_EQ(std::isnan(error.value), std::isnan(min) || std::isnan(max));
            EXPECT_EQ(error.kind.value, 7u);
            EXPECT_EQ(error.body, a);
        }
    }
}

TEST(MisuseHandler, SeesAStaleIdBeforeItIsThrown) {
    static std::string seen;
    const MisuseHandler previous = set_misuse_handler([](const Error& error) { seen = error.what(); });
    World world;
    EXPECT_THROW(world.destroy_body(BodyId{3, 1}), StaleBody);
    EXPECT_NE(seen.find("body 3.1"), std::string::npos) << seen;
    set_misuse_handler(previous);
}

}  // namespace
}  // namespace ecods::world_error_test
