// Many poses at once, and what else is kept with a body.

#include <gtest/gtest.h>

#include <limits>

#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_move_test {
namespace {

class WorldMoveTest : public EachWorld {
  protected:
    WorldMoveTest() {
        for (int i = 0; i < 5; ++i) bodies.push_back(world.create_body(cube, at(3 * i)));
        world.update();
    }
    std::vector<BodyId> bodies;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldMoveTest, broad_phases(), broad_phase_name);

TEST_P(WorldMoveTest, ManyPosesAreThoseOneByOne) {
    World other{WorldOptions{GetParam()}};
    for (int i = 0; i < 5; ++i) other.create_body(cube, at(3 * i));
    other.update();
    std::vector<Pose> poses;
    for (int i = 0; i < 5; ++i) poses.push_back(at(i));
    world.set_poses(bodies, poses);
    for (int i = 0; i < 5; ++i) other.set_pose(numbers_of(bodies[i]), poses[i]);
    world.update();
    other.update();
    EXPECT_EQ(numbers_of(world.colliding_pairs()), numbers_of(other.colliding_pairs()));
    EXPECT_EQ(world.colliding_pairs().size(), 4u);
    EXPECT_EQ(world.digest(), other.digest());
    // The first had its pose already.
    EXPECT_EQ(world.statistics().moved_bodies, 5u + 4u);
    world.check_invariants();

    world.set_poses({}, {});
    world.set_poses(bodies, poses);
    const Statistics before = world.statistics();
    world.update();
    EXPECT_EQ(world.statistics().moved_bodies, before.moved_bodies);
    EXPECT_EQ(world.statistics().two_body_tests, before.two_body_tests);
}

// A mesh whose box is not the library's own.
class CautiousMesh final : public MeshShape {
  public:
    using MeshShape::MeshShape;
    Aabb box(const Pose& pose) const override {
        Aabb box = MeshShape::box(pose);
        box.max += Vec3::Ones();
        return box;
    }
};

// Boxes of bodies of one mesh are found some at a time: shapes that take turns, in numbers that do not divide by four,
// of few vertices and of many, and classes of a caller's own among them.
TEST_P(WorldMoveTest, ManyBoxesAreThoseOneByOne) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (std::uint32_t i = 0; i < 11; ++i) {
        const auto sphere = scenes::sphere(8 + i, i == 0 ? 3 : 6);
        if (i % 3 == 0) shapes.push_back(std::make_shared<const MeshShape>(sphere));
        if (i % 3 == 1) shapes.push_back(std::make_shared<const ConvexSolid>(sphere->vertices()));
        if (i % 3 == 2) shapes.push_back(std::make_shared<const Solid>(i == 2 ? scenes::cube(1) : sphere));
    }
    shapes.push_back(std::make_shared<const CautiousMesh>(scenes::sphere(12, 8)));
    std::vector<BodyId> many;
    std::vector<Pose> poses;
    for (int i = 0; i < 101; ++i) {
        const auto& shape = shapes[static_cast<std::size_t>(i < 50 ? i % 12 : i / 4 % 12)];
        many.push_back(world.create_body(shape, at(10 + i)));
        Pose& pose = poses.emplace_back(at(i % 4 == 0 ? 10 + i : 0.5 * i, 0.1 * i, -i));
        if (i % 2 == 1) pose.R << 0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1 + i;
    }
    world.update();
    world.set_poses(many, poses);
    for (std::size_t i = 0; i < many.size(); ++i) {
        EXPECT_EQ(world.pose(many[i]), poses[i]);
        EXPECT_EQ(world.box(many[i]), world.shape(many[i])->box(poses[i])) << i;
    }
    world.update();
    world.check_invariants();
}

TEST_P(WorldMoveTest, TheLaterPoseOfABodyHolds) {
    const std::vector<BodyId> twice{bodies[0], bodies[1], bodies[0]};
    world.set_poses(twice, std::vector<Pose>{at(9), at(1), at(0.5)});
    EXPECT_EQ(world.pose(bodies[0]), at(0.5));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{bodies[0], bodies[1]}}));
    world.check_invariants();
    // There and back, in one call.
    world.set_poses(twice, std::vector<Pose>{at(9), at(1), at(0.5)});
    world.update();
    EXPECT_TRUE(world.ended().empty());
    world.check_invariants();
}

TEST_P(WorldMoveTest, AllOrNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::uint64_t digest = world.digest();
    std::vector<Pose> poses;
    for (int i = 0; i < 5; ++i) poses.push_back(at(i));
    poses[3].t[1] = nan;
    try {
        world.set_poses(bodies, poses);
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::pose);
        EXPECT_EQ(error.index, 3u);
        EXPECT_EQ(error.body, bodies[3]);
        EXPECT_EQ(error.part, "t(1)");
        const std::string text = error.what();
        EXPECT_NE(text.find("entry 3: body 4.0: pose entry t(1) is nan"), std::string::npos) << text;
    }
    poses[3] = at(3);
    std::vector<BodyId> with_stale = bodies;
    with_stale[4] = BodyId{77, 1};
    try {
        world.set_poses(with_stale, poses);
        ADD_FAILURE();
    } catch (const StaleBody& error) {
        EXPECT_EQ(error.index, 4u);
        EXPECT_EQ(error.body, with_stale[4]);
        EXPECT_NE(std::string(error.what()).find("entry 4: body 77.1"), std::string::npos) << error.what();
    }
    poses.pop_back();
    try {
        world.set_poses(bodies, poses);
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::list_length);
        EXPECT_EQ(error.part, "poses");
        EXPECT_EQ(error.value, 4);
        EXPECT_EQ(std::string(error.what()), "a list of 5 bodies came with a list of 4 poses");
    }
    EXPECT_EQ(world.digest(), digest);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(world.pose(bodies[i]), at(3 * i));
    const Statistics before = world.statistics();
    world.update();
    EXPECT_EQ(world.statistics().moved_bodies, before.moved_bodies);
    EXPECT_EQ(world.statistics().broad_phase.moved, before.broad_phase.moved);
    world.check_invariants();
}

TEST_P(WorldMoveTest, UserDataIsKeptWithTheBody) {
    const std::uint64_t digest = world.digest();
    EXPECT_EQ(world.user_data(bodies[2]), 0u);
    world.set_user_data(bodies[2], ~std::uint64_t{0});
    world.set_user_data(bodies[3], 42);
    EXPECT_EQ(world.user_data(bodies[2]), ~std::uint64_t{0});
    EXPECT_EQ(world.user_data(bodies[3]), 42u);
    EXPECT_EQ(world.digest(), digest);
    world.destroy_body(bodies[2]);
    EXPECT_THROW(world.user_data(bodies[2]), StaleBody);
    EXPECT_THROW(world.set_user_data(bodies[2], 1), StaleBody);
    EXPECT_EQ(world.user_data(world.create_body(cube, at(0))), 0u);
}

TEST_P(WorldMoveTest, ReservedRoomIsNotGrown) {
    World reserved{WorldOptions{GetParam()}};
    reserved.reserve(1000);
    const std::size_t bytes = reserved.statistics().memory_bytes;
    for (int i = 0; i < 1000; ++i) reserved.create_body(cube, at(2 * i));
    EXPECT_EQ(reserved.statistics().memory_bytes, bytes);
    reserved.update();
    reserved.check_invariants();
    EXPECT_EQ(reserved.statistics().memory_bytes, bytes) << "there are no pairs";
}

}  // namespace
}  // namespace ecods::world_move_test
