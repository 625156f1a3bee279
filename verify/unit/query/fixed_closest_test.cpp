// The closest points of convex solids in fixed precision, beside the oracle and the exact direction: equal bits where
// fixed precision decides, whatever the pair.
#include "exact/measure/distance/fixed_closest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/builders.hpp"
#include "environment/each_environment.hpp"
#include "oracle/rounded.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/posed_hulls.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using Solid3 = std::shared_ptr<const ConvexSolid>;

oracle::ExactClosest closest_of_surfaces(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) {
    const auto soup = [](const Posed<ConvexSolid>& body) {
        return oracle::Soup{body.what->mesh().vertices(), body.what->mesh().triangles(), body.pose};
    };
    return oracle::MeshDistances(soup(a), soup(b)).closest();
}

class FixedClosestTest : public testing::Test {
  protected:
    Solid3 hull(double size) {
        std::vector<Vec3> points;
        for (int i = 0; i < 10; ++i) points.push_back(size * random_.direction());
        return std::make_shared<const ConvexSolid>(points);
    }
    Pose pose(double distance) { return {random_.turned().R, distance * random_.direction()}; }

    // Returns true if fixed precision decides all numbers, and expects the true ones then.
    bool ask(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::Radii& radii) {
        QueryMemory memory;
        convex::PosedHulls hulls(a, b, memory);
        const auto closest = convex::find_closest(hulls, nullptr);
        const auto fixed = closest ? convex::find_fixed(hulls, *closest, radii) : std::nullopt;
        if (!fixed) return false;
        const oracle::RoundedDistance truth(closest_of_surfaces(a, b), radii.a, radii.b);
        const auto number = fixed->signed_distance();
        if (number) {
            EXPECT_EQ(*number, truth.signed_distance());
        }
        const auto points = fixed->signed_closest();
        if (points) {
            EXPECT_EQ(points->point_a, truth.point(0));
            EXPECT_EQ(points->point_b, truth.point(1));
        }
        const auto direction = fixed->direction();
        if (direction) {
            EXPECT_EQ(*direction, convex::round_direction(hulls, closest->found));
        }
        return number && points && direction;
    }

    scenes::Random random_{static_cast<std::uint32_t>(testing::GTEST_FLAG(random_seed)) + 1};
};

TEST_F(FixedClosestTest, RandomPairsAreDecided) {
    int decided = 0, count = 0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const Solid3 a = hull(1), b = i % 3 == 0 ? box(Vec3(1, 2, 0.5)) : hull(0.3);
        const double apart = i % 2 == 0 ? 2.5 : 100;
        const Posed<ConvexSolid> x(*a, pose(0.5)), y(*b, pose(apart));
        const exact::Radii radii{i % 4 == 0 ? 0 : random_.uniform(0, 0.5), i % 4 < 2 ? 0 : random_.uniform(0, 0.5)};
        decided += ask(x, y, radii) + ask(y, x, {radii.b, radii.a});
        count += 2;
        if (HasFailure()) return;
    }
    EXPECT_GE(decided, 0.85 * count) << decided << " of " << count;
}

// Feet on and beside the borders of features, gaps of the last digits, and sizes near the ends of the range.
TEST_F(FixedClosestTest, HardPairs) {
    int decided = 0;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const double unit = i % 4 == 0 ? 0x1p-280 : i % 4 == 1 ? 0x1p280 : 1;
        const Solid3 a = box(unit * Vec3(2, 2, 2)), b = box(unit * Vec3(1, 1 + random_.below(2), 1));
        Pose there = at(unit * Vec3(random_.below(5), random_.below(5), random_.below(5)) / 2);
        if (i % 3 == 0) there.R = random_.turned().R;
        const double gap = i % 5 == 0 ? 0x1p-40 : i % 5 == 1 ? 0x1p-20 : 0;
        there.t += unit * (1.5 + gap) * Vec3(1, 0, 0) + unit * (i % 7 == 0 ? 0x1p-50 : 0) * Vec3(0, 1, 0);
        const exact::Radii radii{i % 2 == 0 ? 0 : unit / 8, i % 6 == 0 ? unit * 0x1p-60 : 0};
        decided += ask({*a, Pose()}, {*b, there}, radii) + ask({*b, there}, {*a, Pose()}, {radii.b, radii.a});
        if (HasFailure()) return;
    }
    EXPECT_GE(decided, 60);
}

// The foot of a vertex on a triangle, and on the face whose parallelogram the triangle's corners span.
TEST_F(FixedClosestTest, FeetOfAVertex) {
    using exact::FixedClosest;
    const Pose pose;
    const std::array<Vec3, 3> corners{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const exact::PosedFeature face{&pose, {&corners[0], &corners[1], &corners[2]}, 3};
    const auto number_of = [&](const Vec3& x, FixedClosest::Foot foot, bool is_inverted) -> std::optional<double> {
        const exact::PosedFeature vertex{&pose, {&x, nullptr, nullptr}, 1};
        const auto found = FixedClosest::of_features({vertex, face}, {1, 0.5}, {}, foot);
        const auto back = FixedClosest::of_features({face, vertex}, {0.5, 1}, {}, foot);
        EXPECT_EQ(found.has_value(), back.has_value());
        if (!found || !back) return std::nullopt;
        const auto points = (is_inverted ? found->inverted() : *found).signed_closest();
        const auto turned = (is_inverted ? back->inverted() : *back).signed_closest();
        EXPECT_EQ(points->point_a, turned->point_b);
        EXPECT_EQ(points->point_b, turned->point_a);
        const double way = is_inverted ? -1 : 1;
        EXPECT_EQ(points->point_a, Vec3(x[0], x[1], x[2] - way));
        EXPECT_EQ(points->point_b, Vec3(x[0], x[1], 0.5 * way));
        EXPECT_EQ(*found->direction(), Vec3(0, 0, -1));
        return points->distance;
    };
    constexpr auto in_triangle = FixedClosest::Foot::in_triangle, in_face = FixedClosest::Foot::in_face;
    EXPECT_EQ(number_of({1, 1, 3}, in_triangle, false), 1.5);
    EXPECT_EQ(number_of({1, 1, 3}, in_face, true), 4.5) << "radii add to a depth";
    EXPECT_EQ(number_of({3, 2, 3}, in_face, false), 1.5);
    for (const Vec3& x : {Vec3(3, 2, 3), {2, 2, 3}, {2, 2 + 0x1p-50, 3}, {5, 1, 3}, {-1, 1, 3}}) {
        EXPECT_EQ(number_of(x, in_triangle, false), std::nullopt) << x.transpose();
    }
    EXPECT_EQ(number_of({5, 1, 3}, in_face, false), std::nullopt) << "the vertex is closest to a side";
    EXPECT_EQ(number_of({1, 1, 0}, in_face, false), std::nullopt) << "no direction";
}

TEST_F(FixedClosestTest, EachEnvironment) {
    const Solid3 a = hull(1), b = hull(0.5);
    const Posed<ConvexSolid> x(*a, pose(1)), y(*b, pose(3));
    const auto ask = [&] {
        QueryMemory memory;
        convex::PosedHulls hulls(x, y, memory);
        const auto closest = convex::find_closest(hulls, nullptr);
        const auto fixed = convex::find_fixed(hulls, *closest, {0, 0.25});
        return std::optional(fixed->signed_closest());
    };
    const auto expected = ask();
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
}

}  // namespace
}  // namespace ecods
