// Prisms on convex figures: their depth is that of the figures, whose least way is along the normal of a side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "scenes/plane/plane_figure.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {
namespace {

// Corners on a circle, in integers: counterclockwise, and convex for so few of them.
Outline convex_outline(Random& random) {
    const std::size_t count = 3 + random.below(20);
    const double from = random.uniform(0, 6);
    Outline outline;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = from + 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
        outline.emplace_back(std::round(1e6 * std::cos(angle)), std::round(1e6 * std::sin(angle)));
    }
    return outline;
}

// How far b must go along the normals of a's sides to be beyond them; negative if it is.
double least_way(const Outline& a, const Vec2& at_a, const Outline& b, const Vec2& at_b) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2 along = a[(i + 1) % a.size()] - a[i];
        const Vec2 outwards = Vec2(along.y(), -along.x()) / along.norm();
        double back = std::numeric_limits<double>::infinity();
        for (const Vec2& corner : b) back = std::min(back, outwards.dot(corner + at_b - a[i] - at_a));
        least = std::min(least, -back);
    }
    return least;
}

TEST(PlaneDepth, IsTheLeastAlongNormalsOfSides) {
    Random random(7);
    QueryMemory memory;
    int deep_count = 0;
    for (int i = 0; i < 300; ++i) {
        const Outline a = convex_outline(random), b = convex_outline(random);
        const double way = random.uniform(0, 2.2e6);
        const Vec2 at_a(0, 0), at_b = (way * random.direction()).head<2>();
        // Ways in the plane are at most both diameters: the way along z is longer.
        const double height = 8e6;
        const ConvexSolid solid_a(prism({a, {}}, height)), solid_b(prism({b, {}}, height));
        const Posed<ConvexSolid> posed_a(solid_a, {}), posed_b(solid_b, {Mat3::Identity(), {at_b.x(), at_b.y(), 0}});
        const double expected = std::min(least_way(a, at_a, b, at_b), least_way(b, at_b, a, at_a));
        if (expected < -1) {
            EXPECT_FALSE(depth(posed_a, posed_b, memory));
        } else if (expected > 1) {
            ++deep_count;
            const Depth found = depth(posed_a, posed_b, memory).value();
            EXPECT_NEAR(found.depth, expected, 1e-12 * expected + 1e-8);
            EXPECT_EQ(found.direction.z(), 0);
            const bool is_of_a = found.a.kind == Feature::Kind::face;
            ASSERT_TRUE(is_of_a || found.b.kind == Feature::Kind::face);
            EXPECT_TRUE(side_of_prism({is_of_a ? a : b, {}}, is_of_a ? solid_a.mesh() : solid_b.mesh(),
                                      is_of_a ? found.a.triangle : found.b.triangle));
        }
    }
    EXPECT_GT(deep_count, 150);
}

}  // namespace
}  // namespace ecods::scenes
