#include "ecods/primitives.hpp"

#include <gtest/gtest.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ecods::aabb_test {
namespace {

constexpr double tiny = 0x1p-1074;

Aabb box(double min, double max) {
    return {Vec3::Constant(min), Vec3::Constant(max)};
}

TEST(Aabb, ClosedBoxesShareTheirBoundary) {
    EXPECT_TRUE(overlap(box(0, 1), box(1, 2)));
    EXPECT_TRUE(overlap(box(1, 2), box(0, 1)));
    EXPECT_FALSE(overlap(box(0, 1), box(0x1.0000000000001p0, 2)));
    EXPECT_TRUE(contains(box(0, 1), box(0, 1)));
    EXPECT_FALSE(contains(box(0, 1), box(0, 0x1.0000000000001p0)));
    EXPECT_FALSE(contains(box(0, 1), box(-tiny, 1)));
    EXPECT_TRUE(contains(box(0.0, 1), box(-0.0, 1)));
    EXPECT_EQ(merge(box(0, 1), box(-1, 0)), box(-1, 1));
}

#if defined(__SSE2__)
TEST(Aabb, TheSmallestNumbersCountWhereTheProcessorTakesThemForZero) {
    const Aabb below = box(-tiny, -tiny), zero = box(0, 0), above = box(tiny, 2 * tiny);
    constexpr unsigned flush_and_denormals_are_zero = 0x8040;
    const unsigned saved = _mm_getcsr();
    _mm_setcsr(saved | flush_and_denormals_are_zero);
    const bool do_meet = overlap(zero, above) || overlap(below, zero);
    const bool is_inside = contains(zero, above) || contains(above, zero);
    const Aabb both = merge(merge(zero, above), below);
    _mm_setcsr(saved);
    EXPECT_FALSE(do_meet);
    EXPECT_FALSE(is_inside);
    EXPECT_EQ(both, box(-tiny, 2 * tiny));
}
#endif

}  // namespace
}  // namespace ecods::aabb_test
