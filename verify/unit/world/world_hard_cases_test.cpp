// The cases known to break the broad phases of other libraries that are about worlds: poses, shapes and time. (Those
// about boxes stand in verify/unit/broad_phase/hard_cases_test.cpp.)

#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_hard_cases_test {
namespace {

// The cube of side 1, stretched.
std::shared_ptr<const Mesh> box(const Vec3& size) {
    return scenes::mapped(*scenes::cube(0.5), [&](const Vec3& v) -> Vec3 { return v.cwiseProduct(size); });
}

class WorldHardCases : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldHardCases, broad_phases(), broad_phase_name);

Pose turned(double angle) {
    Pose pose;
    pose.R << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    return pose;
}

// bp-nan-pose
TEST_P(WorldHardCases, APoseThatIsNotANumberIsRefusedAndTheOthersStay) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.25)),
                 c = world.create_body(cube, at(0.5));
    EXPECT_INVALID(world.set_pose(b, at(std::numeric_limits<double>::quiet_NaN())), Argument::pose);
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{a, b}, {a, c}, {b, c}}));
}

// bp-drake-24779: not the box of the sphere around the body.
TEST_P(WorldHardCases, ATurnedRodHasATightBox) {
    const BodyId rod = world.create_body(box(Vec3(10, 0.1, 0.1)), turned(1e-3));
    const Vec3 size = world.box(rod).max - world.box(rod).min;
    EXPECT_NEAR(size[0], 10, 1e-3);
    EXPECT_NEAR(size[1], 0.11, 1e-3);
    EXPECT_NEAR(size[2], 0.1, 1e-9);
}

constexpr ShapeKind wall_kind{7};

// All points from its translation on, on one axis.
class Wall final : public Shape {
  public:
    explicit Wall(int axis) : axis_(axis) {}
    ShapeKind kind() const noexcept override { return wall_kind; }
    Aabb box(const Pose& pose) const override {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Aabb box{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
        box.min[axis_] = pose.t[axis_];
        return box;
    }
    std::uint64_t digest() const noexcept override { return static_cast<std::uint64_t>(axis_); }

  private:
    int axis_;
};

class BoxesMeet final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask&) const override {
        return overlap(a.what->box(a.pose), b.what->box(b.pose));
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return intersects(a, b, ask) ? Relation::touching : Relation::apart;
    }
};

// bp-coal-750
TEST_P(WorldHardCases, SeveralWallsWithoutEndMeetAllThatTheyContain) {
    world.set_test(wall_kind, wall_kind, std::make_shared<BoxesMeet>());
    world.set_test(wall_kind, ShapeKind::mesh(), std::make_shared<BoxesMeet>());
    const BodyId x = world.create_body(std::make_shared<Wall>(0), at(2)),
                 y = world.create_body(std::make_shared<Wall>(1), at(0, 2)),
                 inside = world.create_body(cube, at(3, 0, 0)), outside = world.create_body(cube, at(-3, 0, 0));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{x, y}, {x, inside}}));
    world.set_pose(outside, at(3, 3, 5));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{x, y}, {x, inside}, {x, outside}, {y, outside}}));
}

// bp-sofa-6231
TEST_P(WorldHardCases, TheSameCallsGiveTheSameWorldTwice) {
    const auto fall = [&] {
        World own({.broad_phase = GetParam()});
        own.create_body(box(Vec3(20, 20, 1)), at(0, 0, -1));
        const BodyId falling = own.create_body(cube, at(0, 0, 3));
        std::vector<std::uint64_t> digests;
        for (int frame = 0; frame < 40; ++frame) {
            Pose pose = turned(0.05 * frame);
            pose.t[2] = std::max(0.0, 3 - 0.01 * frame * frame);
            own.set_pose(falling, pose);
            own.update();
            digests.push_back(own.digest());
        }
        return digests;
    };
    EXPECT_EQ(fall(), fall());
}

}  // namespace
}  // namespace ecods::world_hard_cases_test
