// A shape of one's own: balls beside meshes in one world, exactly. A ball meets whatever is within its radius of its
// center, and a point is a triangle of three equal corners, which the library can ask about.
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <bit>
#include <memory>
#include <tuple>

#include "ecods/distance.hpp"
#include "ecods/world.hpp"
#include "scenes/shapes.hpp"

namespace {

using namespace ecods;

const MeshShape& a_point() {
    static const MeshShape shape(Mesh::create({{0, 0, 0}}, {{0, 0, 0}}));
    return shape;
}

// A ball about its own origin. It moves without turning: R of its pose is not read.
class BallShape final : public Shape {
  public:
    static constexpr ShapeKind of_balls{1};  // 0 is the mesh; all others are the caller's

    explicit BallShape(double radius) : radius_(radius) {}
    double radius() const { return radius_; }

    ShapeKind kind() const noexcept override { return of_balls; }
    std::uint64_t digest() const noexcept override { return std::bit_cast<std::uint64_t>(radius_); }
    // The box must contain the ball, and a sum is rounded: twice the radius leaves room, unless the center is 2^52
    // radii away.
    Aabb box(const Pose& pose) const override {
        return {pose.t - Vec3::Constant(2 * radius_), pose.t + Vec3::Constant(2 * radius_)};
    }

  private:
    double radius_;
};

Posed<MeshShape> center_of(const Posed<Shape>& ball) {
    return {a_point(), {.t = ball.pose.t}};
}
double radius_of(const Posed<Shape>& ball) {
    return static_cast<const BallShape&>(*ball.what).radius();
}

// The world gives the shapes in the order in which the kinds were registered. `ecods::` means the question about two
// meshes, not the one that a TwoBodyTest may answer.
class BallAndMesh final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& ball, const Posed<Shape>& mesh, const Ask& ask) const override {
        const Posed<MeshShape> body(static_cast<const MeshShape&>(*mesh.what), mesh.pose);
        return ecods::within(center_of(ball), body, radius_of(ball), ask);
    }
};

// The sum of the radii is exact where they are multiples of one small fraction, as here.
class BallAndBall final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::within(center_of(a), center_of(b), radius_of(a) + radius_of(b), ask);
    }
};

}  // namespace

int main() {
    World world;
    world.set_test(BallShape::of_balls, ShapeKind::mesh(), std::make_shared<BallAndMesh>());
    world.set_test(BallShape::of_balls, BallShape::of_balls, std::make_shared<BallAndBall>());
    const auto ball = std::make_shared<BallShape>(0.5);
    const BodyId cube = world.create_body(scenes::cube(1), {});
    const BodyId left = world.create_body(ball, {.t = {1.75, 0, 0}});
    const BodyId right = world.create_body(ball, {.t = {2.75, 0, 0}});
    for (const double x : {1.75, 1.5, 0x1.7ffffffffffffp0}) {
        world.set_pose(left, {.t = {x, 0, 0}});
        world.set_pose(right, {.t = {x + 1, 0, 0}});
        world.update();
        fmt::print("balls at {} and {}:", x, x + 1);
        for (const BodyPair& pair : world.colliding_pairs()) fmt::print(" {}", fmt::streamed(pair));
        fmt::print("\n");
    }
    // What a test does not answer is refused, and not taken for "no".
    try {
        std::ignore = world.distance(cube, left);
    } catch (const NotSupported& error) {
        fmt::print("{}\n", error.what());
    }
}
