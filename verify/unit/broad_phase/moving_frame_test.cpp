#include "broad_phase/candidates/moving_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <limits>
#include <random>

namespace ecods::moving_frame_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

[[gnu::noinline]] Aabb in_frame(const Vec3& at, const Aabb& box, int rounding) {
    std::fesetround(rounding);
    MovingFrame frame;
    frame.start(at);
    frame.advance();
    const Aabb result = frame.of(box);
    std::fesetround(FE_TONEAREST);
    return result;
}

// Whether a <= x - y, exactly: the rounded difference and what it lacks (Knuth's two-sum).
bool is_at_most_difference(double a, double x, double y) {
    const volatile double rounded = x - y;
    const volatile double back = rounded - x;
    const volatile double lacks = (x - (rounded - back)) + (-y - back);
    return a < rounded || (a == rounded && lacks >= 0);
}

TEST(MovingFrame, AtTheOriginItHoldsTheVeryBox) {
    const Aabb box{{-0.1, 1e-310, -infinity}, {0.3, 7, largest}};
    EXPECT_EQ(MovingFrame().of(box), box);
    EXPECT_EQ(MovingFrame().of_before(box), box);
}

TEST(MovingFrame, HoldsMoreThanTheBoxHoweverItIsRounded) {
    std::mt19937_64 random(17);
    const auto number = [&](int exponents) {
        const double x = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % exponents) - 53);
        return random() % 2 == 0 ? x : -x;
    };
    for (const int rounding : std::array{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        for (int i = 0; i < 20'000; ++i) {
            Vec3 at;
            Aabb box;
            for (int k = 0; k < 3; ++k) {
                at[k] = number(i % 2 == 0 ? 4 : 120);
                const double a = number(4), b = number(4);
                box.min[k] = std::min(a, b) + (i % 3 == 0 ? at[k] : 0);
                box.max[k] = std::max(a, b) + (i % 3 == 0 ? at[k] : 0);
            }
            const Aabb result = in_frame(at, box, rounding);
            for (int k = 0; k < 3; ++k) {
                ASSERT_TRUE(is_at_most_difference(result.min[k], box.min[k], at[k])) << rounding;
                ASSERT_TRUE(is_at_most_difference(-result.max[k], -box.max[k], -at[k])) << rounding;
                ASSERT_LE(result.max[k] - result.min[k], (box.max[k] - box.min[k]) * 1.001 + 0x1p-40 * at.norm());
            }
        }
    }
}

TEST(MovingFrame, TheEndsOfTheRangeStayWhereTheyAre) {
    const Aabb box{{largest, -infinity, -largest}, {infinity, infinity, -largest / 2}};
    const Aabb result = in_frame({-largest, 5, largest}, box, FE_TONEAREST);
    EXPECT_LE(result.min[0], largest);
    EXPECT_EQ(result.max[0], infinity);
    EXPECT_EQ(result.min[1], -infinity);
    EXPECT_EQ(result.max[1], infinity);
    EXPECT_EQ(result.min[2], -infinity);
    EXPECT_GE(result.max[2], -largest);
}

// What cannot be followed is not: the frame stays.
TEST(MovingFrame, StaysWhereNumbersEnd) {
    MovingFrame frame;
    frame.start({infinity, 0, 0});
    EXPECT_FALSE(frame.is_moving());
    frame.start({largest / 2, 0, 0});
    for (int i = 0; i < 4; ++i) frame.advance();
    EXPECT_FALSE(frame.is_moving());
    EXPECT_EQ(frame.went(), Vec3::Zero());
    EXPECT_FALSE(frame.is_at_origin());
}

}  // namespace
}  // namespace ecods::moving_frame_test
