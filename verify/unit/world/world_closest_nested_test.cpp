// A caller's two-body test asks another world while one searches for its closest pair, in the same memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

constexpr ShapeKind compound_kind{5};

// A unit cube, which answers by a world of its own.
class Compound final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return compound_kind; }
    Aabb box(const Pose& pose) const override { return {.min = pose.t, .max = pose.t + Vec3::Ones()}; }
    std::uint64_t digest() const noexcept override { return 1; }
};

class CompoundTest final : public TwoBodyTest {
  public:
    CompoundTest() {
        for (int i = 0; i < 50; ++i) {
            inner_.create_body({.shape = part_, .pose = at(2.0 * i), .filter = {.groups = 1 + std::uint64_t(i % 2)}});
        }
    }
    bool answers(Question question) const noexcept override {
        return question == Question::within || question == Question::distance;
    }
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return distance(a, b, ask) == 0;
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        EXPECT_EQ(inner_.closest_pair(World::no_limit, 1, 2, ask)->distance, 1);
        return std::max(0.0, (a.pose.t - b.pose.t).cwiseAbs().maxCoeff() - 1);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, const Ask& ask) const override {
        return distance(a, b, ask) <= d;
    }

  private:
    std::shared_ptr<const Shape> part_ = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    World inner_;
};

TEST(WorldClosestNested, AsksAnotherWorldInTheSameMemory) {
    const auto test = std::make_shared<const CompoundTest>();
    const auto shape = std::make_shared<const Compound>();
    World world;
    world.set_test(compound_kind, compound_kind, test);
    for (int i = 0; i < 12; ++i) {
        world.create_body({.shape = shape, .pose = at(1.5 * i * i, 0, 0), .filter = {.groups = 1}});
        world.create_body({.shape = shape, .pose = at(1.5 * i * i, 30.0 - 2 * i, 0), .filter = {.groups = 2}});
    }
    QueryMemory memory;
    for (int step = 0; step < 3; ++step) {
        double least = std::numeric_limits<double>::infinity();
        for (const BodyId a : world.bodies()) {
            for (const BodyId b : world.bodies()) {
                if (world.filter(a).groups == 1 && world.filter(b).groups == 2) {
                    least = std::min(least, world.distance(a, b, memory));
                }
            }
        }
        const std::optional<ClosestPair> found = world.closest_pair(World::no_limit, 1, 2, memory);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->distance, least);
        EXPECT_EQ(world.distance(found->bodies.a, found->bodies.b, memory), least);
        world.destroy_body(found->bodies.b);
    }
}

}  // namespace
}  // namespace ecods
