// Two convex solids within a limit, tried along an axis first: whatever the axis, the answer is that of the search.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/distance.hpp"
#include "environment/each_environment.hpp"
#include "query/convex/solid_pair.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using Convex = std::shared_ptr<const ConvexSolid>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Convex hull_of(scenes::Random& random, int count, double size) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(size * random.direction());
    return std::make_shared<const ConvexSolid>(points);
}

// Expects the answer of the search about the limit, with the axis and with the one that is left in it.
void expect_as_searched(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit, const Vec3& first) {
    QueryMemory memory;
    PairWitness unknown;
    const bool expected = limit >= infinity || convex::within(a, b, exact::Limit{limit}, memory, unknown);
    Vec3 axis = first;
    PairWitness witness;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(convex::within(a, b, limit, memory, witness, axis), expected) << limit << ", " << axis.transpose();
    }
    Vec3 opposite = -axis;
    EXPECT_EQ(convex::within(b, a, limit, memory, witness, opposite), expected) << limit;
}

// The distance itself, the doubles beside it, and numbers far from it.
std::vector<double> limits_near(double distance) {
    return {distance, std::nextafter(distance, 0), std::nextafter(distance, infinity), distance / 2, 2 * distance,
            infinity};
}

std::vector<Vec3> axes_for(scenes::Random& random, const Vec3& between) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {Vec3::Zero(),          between,         Vec3(-between),       random.direction(),
            Vec3(1e300 * between), Vec3(nan, 1, 0), Vec3(infinity, 0, 0), Vec3(0, 0, 0x1p-1074),
            Vec3(1e-200 * between)};
}

TEST(WithinAxis, AnyAxisGivesTheAnswer) {
    scenes::Random random(5);
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE(i);
        const Convex a = hull_of(random, i % 4 == 0 ? 150 : 12, 1),
                     b = i % 3 == 0 ? box(Vec3(1, 2, 1)) : hull_of(random, 8, 1);
        const Pose pose = random.turned(), there(random.turned().R, random.direction() * random.uniform(1.5, 4));
        const Posed<ConvexSolid> x(*a, pose), y(*b, there);
        const double d = distance(x, y);
        if (!(d > 0)) continue;
        const SignedDistance found = signed_distance(x, y);
        for (const double limit : limits_near(d)) {
            for (const Vec3& axis : axes_for(random, found.direction)) expect_as_searched(x, y, limit, axis);
        }
        if (HasFailure()) return;
    }
}

// Faces that are parallel, at gaps of the last digits: the axis alone must not decide too much.
TEST(WithinAxis, GapsOfTheLastDigits) {
    const Convex box_a = box(Vec3(2, 2, 2)), box_b = box(Vec3(1, 1, 1));
    scenes::Random random(6);
    for (const double gap : {0x1p-52, 0x1p-50, 0x1p-40, 0x1p-20}) {
        for (const double far : {0.0, 0x1p20}) {
            const Posed<ConvexSolid> x(*box_a, at(far)), y(*box_b, at(far + (1.5 + gap)));
            const double d = distance(x, y);
            for (const double limit : limits_near(d)) {
                if (limit == 0) continue;
                for (const Vec3& axis : axes_for(random, Vec3(1, 0, 0))) expect_as_searched(x, y, limit, axis);
            }
        }
    }
}

TEST(WithinAxis, TheAxisThatIsLeftNeedsNoSearch) {
    const Convex a = box(Vec3(2, 2, 2)), b = box(Vec3(1, 1, 1));
    const Posed<ConvexSolid> x(*a, Pose());
    QueryMemory memory;
    PairWitness witness;
    // A direction that the centers do not show.
    Vec3 axis = Vec3(0, 1, 0);
    const Posed<ConvexSolid> y(*b, at(2, 1.4, 0));
    EXPECT_FALSE(convex::within(x, y, 0.375, memory, witness, axis));
    EXPECT_EQ(axis, Vec3(1, 0, 0));
    const PairWitness after = witness;
    // The pair moves: the axis still parts it, and no triangles are searched.
    EXPECT_FALSE(convex::within(x, {*b, at(2, -1.4, 0.5)}, 0.375, memory, witness, axis));
    EXPECT_EQ(axis, Vec3(1, 0, 0));
    EXPECT_EQ(witness.a, after.a);
    EXPECT_EQ(witness.b, after.b);
    // Bodies that meet leave the axis as it is.
    EXPECT_TRUE(convex::within(x, {*b, at(1, 0, 0)}, 0.375, memory, witness, axis));
    EXPECT_EQ(axis, Vec3(1, 0, 0));
}

TEST(WithinAxis, EachEnvironment) {
    scenes::Random random(7);
    const Convex a = hull_of(random, 12, 1), b = hull_of(random, 12, 1);
    const Posed<ConvexSolid> x(*a, random.turned()), y(*b, {random.turned().R, Vec3(2.5, 0.5, 0)});
    const double d = distance(x, y);
    const SignedDistance found = signed_distance(x, y);
    const auto ask = [&] {
        std::uint64_t bits = 0;
        for (const double limit : limits_near(d)) {
            for (const Vec3& first : {Vec3(Vec3::Zero()), found.direction}) {
                QueryMemory memory;
                PairWitness witness;
                Vec3 axis = first;
                bits = 2 * bits + (convex::within(x, y, limit, memory, witness, axis) ? 1 : 0);
            }
        }
        return bits;
    };
    const auto expected = ask();
    environment::in_each_environment(
        ask, [&](std::uint64_t got, const std::string& where) { EXPECT_EQ(got, expected) << where; });
}

}  // namespace
}  // namespace ecods
