// From when on a box on the move may meet others: against fractions of integers, in all rounding modes.
#include "bounds/moving_box.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scenes/random.hpp"

namespace ecods::moving_box_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

struct Fraction {
    std::int64_t numerator, denominator;  // the latter positive

    bool operator<(const Fraction& other) const {
        return numerator * other.denominator < other.numerator * denominator;
    }
};

// The first time at which boxes of small integers meet; a negative one where they never do.
Fraction first_time(const Aabb& moving, const Vec3& motion, const Aabb& box) {
    Fraction from{0, 1}, to{1000000, 1};
    for (int k = 0; k < 3; ++k) {
        const auto side = [&](double gap, double speed) {  // at times s with gap <= s * speed
            const auto g = static_cast<std::int64_t>(gap), v = static_cast<std::int64_t>(speed);
            if (v > 0) from = std::max(from, Fraction{g, v});
            if (v < 0) to = std::min(to, Fraction{-g, -v});
            if (v == 0 && g > 0) to = {-1, 1};
        };
        side(box.min[k] - moving.max[k], motion[k]);
        side(moving.min[k] - box.max[k], -motion[k]);
    }
    return to < from ? Fraction{-1, 1} : from;
}

class MovingBoxTest : public testing::Test {
  protected:
    double integer(int size) { return std::floor(random_.uniform(-size, size + 1)); }
    Vec3 place(int size) { return {integer(size), integer(size), integer(size)}; }
    Aabb box(int size) {
        const Vec3 at = place(size);
        return {at, at + place(3).cwiseAbs()};
    }
    // At most the truth, and by little. Of what is never met it may say anything.
    static void judge(double answer, const Fraction& truth) {
        if (truth.numerator < 0) return;
        const long double exact = static_cast<long double>(truth.numerator) / truth.denominator;
        ASSERT_LE(answer, exact);
        ASSERT_GE(answer, exact * (1 - 0x1p-46L));
    }

    scenes::Random random_{7};
};

TEST_F(MovingBoxTest, IsABoundAndATightOne) {
    int met = 0, missed = 0;
    for (int i = 0; i < 40000; ++i) {
        const Aabb moving = box(8), other = box(20);
        const Vec3 motion = i % 3 == 0 ? Vec3(other.min - moving.min) : place(12);
        const Fraction truth = first_time(moving, motion, other);
        for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            for (const double scale : {1.0, 0x1p-480, 0x1p-900, 0x1p900}) {
                const Aabb a{scale * moving.min, scale * moving.max}, b{scale * other.min, scale * other.max};
                const Vec3 by = scale * motion;
                std::fesetround(mode);
                const double answer = MovingBox(a, by).meets_from(b);
                std::fesetround(FE_TONEAREST);
                ASSERT_NO_FATAL_FAILURE(judge(answer, truth));
                if (truth.numerator >= 0) {
                    ++met;
                } else {
                    missed += answer == infinity;
                }
            }
        }
    }
    EXPECT_GT(met, 60000);
    EXPECT_GT(missed, 200000) << "what passes by is left out";
}

TEST_F(MovingBoxTest, SegmentsAndRaysAreBoxesOfNoSize) {
    for (int i = 0; i < 40000; ++i) {
        const Vec3 from = place(8), to = place(8);
        const Aabb other = box(8);
        const Fraction truth = first_time({from, from}, to - from, other);
        for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            const double of_segment = MovingBox(Segment{from, to}).meets_from(other);
            const double of_ray = MovingBox(Ray{from, to - from}).meets_from(other);
            std::fesetround(FE_TONEAREST);
            ASSERT_NO_FATAL_FAILURE(judge(of_segment, truth));
            ASSERT_NO_FATAL_FAILURE(judge(of_ray, truth));
        }
    }
}

// The difference of its ends is no double.
TEST_F(MovingBoxTest, TheEndOfASegmentCounts) {
    const Segment segment{Vec3(-1, 0, 0), Vec3(0x1p60 + 0x1p10, 0, 0)};
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const double from = MovingBox(segment).meets_from({segment.b, segment.b});
        std::fesetround(FE_TONEAREST);
        EXPECT_LE(from, 1);
        EXPECT_GT(from, 1 - 0x1p-40);
    }
}

TEST_F(MovingBoxTest, EndsOfTheRangeOfDoubles) {
    const auto point = [](double x) { return Aabb{Vec3(x, 0, 0), Vec3(x, 0, 0)}; };
    const auto along_x = [](double x) { return Vec3(x, 0, 0); };
    EXPECT_LE(MovingBox(point(0), along_x(least)).meets_from(point(least)), 1);
    EXPECT_LE(MovingBox(point(0), along_x(least)).meets_from(point(largest)), largest) << "far beyond, but met";
    EXPECT_LE(MovingBox(point(-largest), along_x(largest)).meets_from(point(largest)), 2);
    EXPECT_GT(MovingBox(point(-largest), along_x(0x1p1000)).meets_from(point(largest)), 0x1p23);
    EXPECT_LE(MovingBox(Segment{Vec3(-largest, 0, 0), Vec3(largest, 0, 0)}).meets_from(point(largest)), 1);
    EXPECT_EQ(MovingBox(point(0), along_x(1)).meets_from(point(-least)), infinity);
    EXPECT_EQ(MovingBox(point(0), along_x(1)).meets_from(point(0)), 0);
    EXPECT_EQ(MovingBox(point(0), along_x(0)).meets_from(point(least)), infinity);
    EXPECT_EQ(MovingBox(point(0), along_x(0)).meets_from(point(-0.0)), 0);
    // Sides at infinity, as of poses that overflow.
    const Aabb all{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    EXPECT_EQ(MovingBox(all, along_x(1)).meets_from(point(3)), 0);
    EXPECT_EQ(MovingBox(all, along_x(0)).meets_from(all), 0);
    EXPECT_EQ(MovingBox(point(3), along_x(-1)).meets_from(all), 0);
    EXPECT_LE(MovingBox(point(3), along_x(1)).meets_from(point(infinity)), largest);
}

TEST_F(MovingBoxTest, BoxesWithinAreMetNoEarlier) {
    for (int i = 0; i < 40000; ++i) {
        const auto any = [&](double size) {
            const Vec3 at(random_.uniform(-4, 4), random_.uniform(-4, 4), random_.uniform(-4, 4));
            return Aabb{at, at + Vec3::Constant(size)};
        };
        const Aabb outer = any(1);
        const Vec3 low(random_.uniform(0, 0.5), random_.uniform(0, 0.5), random_.uniform(0, 0.5));
        const Vec3 motion(random_.uniform(-4, 4), random_.uniform(-4, 4), i % 2 == 0 ? 0 : random_.uniform(-4, 4));
        const MovingBox moving(any(0.5), motion);
        ASSERT_GE(moving.meets_from({outer.min + low, outer.max - low}), moving.meets_from(outer));
    }
}

}  // namespace
}  // namespace ecods::moving_box_test
