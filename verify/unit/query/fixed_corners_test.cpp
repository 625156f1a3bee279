// Corners of patches in fixed precision beside integers of any length: equal bits, whatever the pair; and boxes on a
// lattice beside the oracle, all of them, and poses next to them.
#include "query/patch/fixed_corners.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "ecods/contact.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/patch/patch_rounding.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods::patches {
namespace {

using convex::LeastDifference;
using scenes::Random;

struct Count {
    int asked = 0, rounded = 0;
};

// Expects the corners of integers. Leaves out pairs that are flat and touch, whose normal is the hulls' own.
void expect_corners(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::Radii& radii, Count& count) {
    QueryMemory memory;
    convex::PosedHulls hulls(a, b, memory);
    LeastDifference least;
    double distance = 0;
    if (const auto closest = convex::find_closest(hulls, nullptr)) {
        least = least_of_closest(hulls, *closest);
        distance = round_distance(hulls, closest->found);
    } else {
        const auto depth = depths::find_depth(hulls, depths::DepthMemory::of(memory));
        ASSERT_TRUE(depth);
        least = least_of(hulls, *depth);
        distance = depth->depth;
    }
    const auto fixed = FixedCorners::of(hulls, least, radii);
    convex::LeastPairs pairs, same;
    list_least(hulls, least, distance, std::nullopt, pairs);
    list_least(hulls, least, distance, fixed ? fixed->way() : std::nullopt, same);
    ASSERT_EQ(pairs.size(), same.size());
    const Reach reach(radii);
    const ExactNormal normal = scaled_normal(hulls, least);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        ASSERT_EQ(pairs[i], same[i]);
        ++count.asked;
        PatchCorner found, expected;
        if (!fixed || !fixed->round(pairs[i], found)) continue;
        ++count.rounded;
        round_least(hulls, pairs[i], reach, normal, expected);
        ASSERT_EQ(found.point_a, expected.point_a);
        ASSERT_EQ(found.point_b, expected.point_b);
        ASSERT_EQ(found.middle, expected.middle);
    }
}

std::shared_ptr<const ConvexSolid> any_hull(Random& random) {
    switch (random.below(3)) {
        case 0:
            return std::make_shared<ConvexSolid>(box(Vec3(-1, -2, -1), Vec3(2, 1, 2)));
        case 1:
            return std::make_shared<ConvexSolid>(
                scenes::to_mesh(scenes::prism(static_cast<int>(3 + random.below(8)), 4, 3), 1));
        default:
            return std::make_shared<ConvexSolid>(scenes::to_mesh(scenes::random_lattice_hull(2, 7, random), 1));
    }
}

// A turn around the third axis by any angle, so that faces across it stay parallel; not quite orthogonal.
Mat3 turned(Random& random) {
    const double angle = random.uniform(0, 6.25), c = std::cos(angle), s = std::sin(angle);
    Mat3 R;
    R << c, -s, 0, s, c, 0, 0, 0, 1;
    return R;
}

TEST(FixedCorners, AsIntegersRoundThem) {
    Random random(51);
    Count count;
    for (int i = 0; i < 1500; ++i) {
        SCOPED_TRACE(i);
        const auto a = any_hull(random), b = any_hull(random);
        Pose p, q;
        const Mat3 common = random.rotation().toRotationMatrix();
        switch (random.below(4)) {
            case 0:
                q.R = turned(random);
                break;
            case 1:
                p.R = q.R = common;
                break;
            case 2:
                p.R = common * 0x1p-30;
                q.R = random.rotation().toRotationMatrix() * 0x1p-30;
                break;
            default:
                break;
        }
        for (double& x : q.t)
            x = random.below(2) == 0 ? random.uniform(-5, 5) : std::round(random.uniform(-10, 10)) / 2;
        if (random.below(4) == 0) p.t = Vec3(random.uniform(-1, 1), random.uniform(-100, 100), 0.1);
        q.t += p.t;
        exact::Radii radii;
        if (random.below(3) == 0) radii = {0.1, random.below(2) == 0 ? 0 : 0.25};
        expect_corners({*a, p}, {*b, q}, radii, count);
        expect_corners({*b, q}, {*a, p}, radii, count);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(count.asked, 5000);
    EXPECT_GT(count.rounded, 99 * count.asked / 100);
}

// Points that do not fit into 128 bits, and translations far from the origin.
TEST(FixedCorners, OfPointsThatAreOff) {
    Random random(52);
    Count count;
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE(i);
        const auto a = any_hull(random), b = any_hull(random);
        Pose p, q;
        p.R = random.rotation().toRotationMatrix();
        q.R = random.below(2) == 0 ? p.R : random.rotation().toRotationMatrix();
        for (Pose* pose : {&p, &q}) {
            pose->R(0, 0) += std::ldexp(random.uniform(1, 2), -80);
            if (random.below(2) == 0)
                pose->R(1, 2) = std::ldexp(random.uniform(1, 2), -static_cast<int>(random.below(90)));
            for (double& x : pose->t) x = random.uniform(-3, 3) * std::ldexp(1.0, -static_cast<int>(random.below(40)));
        }
        if (random.below(3) == 0) {
            p.t += Vec3(0x1p40, 0.1, -0x1p60);
            q.t += Vec3(0x1p40, 0.1, -0x1p60);
        }
        exact::Radii radii;
        if (random.below(3) == 0) radii = {0.1, 0x1p-70};
        expect_corners({*a, p}, {*b, q}, radii, count);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(count.rounded, count.asked / 2);
}

}  // namespace
}  // namespace ecods::patches
