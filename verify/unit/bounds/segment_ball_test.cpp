// Segments and balls against boxes: exact, whatever the rounding mode. The model is rational arithmetic, and decides
// by clipping where the library looks for a separating axis.
#include <gtest/gtest.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "bounds/ball_bounds.hpp"
#include "bounds/segment_bounds.hpp"
#include "ecods/error.hpp"
#include "environment/float_mode.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"

namespace ecods::segment_ball_test {
namespace {

using Rational = CGAL::Gmpq;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The parameters at which the line is within all sides, as a range that shrinks side by side.
bool model_meets(const Segment& segment, const Aabb& box) {
    Rational first = 0, last = 1;
    for (int k = 0; k < 3; ++k) {
        const Rational a = segment.a[k], d = Rational(segment.b[k]) - a;
        if (box.min[k] == infinity || box.max[k] == -infinity) return false;
        for (const bool is_upper : {false, true}) {
            const double side = is_upper ? box.max[k] : box.min[k];
            if (std::isinf(side)) continue;
            const Rational gap = is_upper ? Rational(side) - a : a - Rational(side);  // not negative: inside at a
            const Rational slope = is_upper ? d : -d;                                 // gap(t) = gap - slope t
            if (slope == 0 && gap < 0) return false;
            if (slope > 0) last = std::min(last, gap / slope);
            if (slope < 0) first = std::max(first, gap / slope);
        }
    }
    return first <= last;
}

bool model_meets(const Ball& ball, const Aabb& box) {
    if (std::isinf(ball.radius)) return true;
    Rational sum = 0;
    for (int k = 0; k < 3; ++k) {
        if (box.min[k] == infinity || box.max[k] == -infinity) return false;
        const Rational c = ball.center[k];
        Rational nearest = c;
        if (!std::isinf(box.min[k])) nearest = std::max(nearest, Rational(box.min[k]));
        if (!std::isinf(box.max[k])) nearest = std::min(nearest, Rational(box.max[k]));
        sum += (nearest - c) * (nearest - c);
    }
    return sum <= Rational(ball.radius) * Rational(ball.radius);
}

struct Tally {
    int meeting = 0, apart = 0, undecided = 0;
};

// One question in the rounding modes, and with subnormals taken for zero, by the function and by what prepares it for
// many boxes.
template <class Bounds, class Set>
void check(const Set& set, const Aabb& box, Tally& tally) {
    const bool expected = model_meets(set, box);
    ++(expected ? tally.meeting : tally.apart);
    for (const environment::FloatMode& mode : std::span(environment::float_modes).first(5)) {
        bool answer, is_in_box;
        BoxVerdict verdict = BoxVerdict::unknown;
        {
            const environment::InFloatMode in_mode(mode);
            const Bounds bounds(set);
            answer = overlap(set, box) && bounds.meets(box);
            is_in_box = overlap(bounds.box(), box);
            if (is_in_box) verdict = bounds.judge(box);
        }
        ASSERT_EQ(answer, expected) << mode.name;
        if (expected) {
            ASSERT_TRUE(is_in_box && verdict != BoxVerdict::apart) << mode.name;
        }
        if (!expected) {
            ASSERT_NE(verdict, BoxVerdict::meeting) << mode.name;
        }
        if (is_in_box && verdict == BoxVerdict::unknown) ++tally.undecided;
    }
}

// Numbers with many ties, and of all sizes.
double number(scenes::Random& random, int kind) {
    const double unit = std::floor(random.uniform(-4, 5));
    switch (kind) {
        case 0:
            return unit;
        case 1:
            return random.uniform(-4, 4);
        case 2:
            return std::ldexp(unit, static_cast<int>(random.uniform(-1074, 1020)));
        case 3:
            return unit * std::numeric_limits<double>::denorm_min();
        case 4:
            return unit * 0x1p1021;
        case 5:
            return std::nextafter(unit, random.uniform(0, 1) < 0.5 ? -infinity : infinity);
        default:
            return std::ldexp(unit, -520);
    }
}
constexpr int kind_count = 7;

Vec3 point(scenes::Random& random, int kind) {
    return {number(random, kind), number(random, kind), number(random, kind)};
}

Aabb box(scenes::Random& random, int kind) {
    const Vec3 a = point(random, kind), b = point(random, kind);
    Aabb result{a.cwiseMin(b), a.cwiseMax(b)};
    for (int k = 0; k < 3; ++k) {
        const double chance = random.uniform(0, 1);
        if (chance < 0.2) result.max[k] = result.min[k];
        if (chance > 0.95) result.max[k] = infinity;
        if (chance > 0.98) result.min[k] = infinity;
        if (chance > 0.9 && chance < 0.93) result.min[k] = -infinity;
        if (chance > 0.9 && chance < 0.91) result.max[k] = -infinity;
    }
    return result;
}

TEST(SegmentBox, IsDecidedAsRationalsDo) {
    scenes::Random random(1);
    Tally tally;
    for (int i = 0; i < 7000; ++i) {
        const int kind = i % kind_count;
        const Segment segment{point(random, kind), i % 11 == 0 ? point(random, i % kind_count) : point(random, kind)};
        check<SegmentBounds>(segment, box(random, kind), tally);
        check<SegmentBounds>(Segment{segment.a, segment.a}, box(random, kind), tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.meeting, 1000);
    EXPECT_GT(tally.apart, 1000);
    EXPECT_GT(tally.undecided, 1000);
}

// Through a corner or an edge exactly, and beside it by the last digit of one coordinate.
TEST(SegmentBox, LinesThroughEdgesAndCornersTouch) {
    scenes::Random random(2);
    Tally tally;
    for (int i = 0; i < 3000; ++i) {
        const double scale = i % 3 == 0 ? 0x1p-400 : i % 3 == 1 ? 1 : 0x1p+480;
        const Vec3 direction = point(random, 0) * scale;
        Aabb touched{Vec3(1, 2, 3) * scale, Vec3(5, 4, 3 + i % 4) * scale};
        Vec3 corner;
        for (int k = 0; k < 3; ++k) corner[k] = random.uniform(0, 1) < 0.5 ? touched.min[k] : touched.max[k];
        Segment segment{corner - 3 * direction, corner + 5 * direction};
        check<SegmentBounds>(segment, touched, tally);
        double& digit = (i % 2 == 0 ? segment.a : segment.b)[i % 3];
        digit = std::nextafter(digit, i % 4 < 2 ? -infinity : infinity);
        check<SegmentBounds>(segment, touched, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.meeting, 3000);
    EXPECT_GT(tally.apart, 300);
    EXPECT_GT(tally.undecided, 10000);
}

TEST(BallBox, IsDecidedAsRationalsDo) {
    scenes::Random random(3);
    Tally tally;
    for (int i = 0; i < 7000; ++i) {
        const int kind = i % kind_count;
        const double radius = i % 50 == 0 ? infinity : std::abs(number(random, i % 9 == 0 ? i / 9 % kind_count : kind));
        check<BallBounds>(Ball{point(random, kind), radius}, box(random, kind), tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.meeting, 1000);
    EXPECT_GT(tally.apart, 1000);
    EXPECT_GT(tally.undecided, 1000);
}

// 3, 4, 12 and 13, along faces, edges and corners: touching exactly, or beside it by the last digit of one number.
TEST(BallBox, BallsTouchFacesEdgesAndCorners) {
    scenes::Random random(4);
    Tally tally;
    const std::array<std::array<double, 4>, 4> gaps = {{{3, 4, 12, 13}, {3, 4, 0, 5}, {0, 0, 7, 7}, {8, 9, 12, 17}}};
    for (int i = 0; i < 3000; ++i) {
        const double scale = i % 3 == 0 ? 0x1p-530 : i % 3 == 1 ? 1 : 0x1p+500;
        const auto& gap = gaps[static_cast<std::size_t>(i) % 4];
        const Aabb touched{Vec3(-1, -2, -3) * scale, Vec3(1, 0x1p40, -3 + i % 5) * scale};
        Ball ball{Vec3::Zero(), gap[3] * scale};
        for (int k = 0; k < 3; ++k) {
            const double distance = gap[static_cast<std::size_t>(k)] * scale;
            ball.center[k] = random.uniform(0, 1) < 0.5 ? touched.min[k] - distance : touched.max[k] + distance;
        }
        check<BallBounds>(ball, touched, tally);
        double& digit = i % 4 == 3 ? ball.radius : ball.center[i % 4];
        digit = std::nextafter(digit, i % 8 < 4 ? -infinity : infinity);
        check<BallBounds>(ball, touched, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.meeting, 3000);
    EXPECT_GT(tally.apart, 1000);
    EXPECT_GT(tally.undecided, 10000);
}

// Gaps of 3 and 4 between numbers whose digits lie far apart: too wide for short integers.
TEST(BallBox, BallsTouchFarFromTheOrigin) {
    Tally tally;
    for (const double scale : {0x1p-950, 1.0, 0x1p900}) {
        for (int wide = 8; wide < 48; ++wide) {
            const double unit = std::ldexp(1.0, wide - 52), x = std::ldexp(1.0, wide);
            const Aabb touched{Vec3(-x, -1, -1) * scale, Vec3(x, 1 + 0x1p-52, 1) * scale};
            Ball ball{Vec3(x + 3 * unit, (1 + 0x1p-52) + 4 * unit, 0.5) * scale, 5 * unit * scale};
            check<BallBounds>(ball, touched, tally);
            ball.radius = std::nextafter(ball.radius, 0);
            check<BallBounds>(ball, touched, tally);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_EQ(tally.meeting, 120);
    EXPECT_EQ(tally.apart, 120);
}

TEST(SegmentBox, EndsMustBeFinite) {
    EXPECT_NO_THROW(validate(Segment{Vec3(1, 2, 3), Vec3(1, 2, 3)}));
    try {
        validate(Segment{Vec3(1, 2, 3), Vec3(1, -infinity, 3)});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::segment);
        EXPECT_EQ(error.part, "b(1)");
        EXPECT_EQ(error.value, -infinity);
        EXPECT_STREQ(error.what(), "segment: end 1, axis 1: coordinate is -inf, not finite");
    }
    EXPECT_INVALID(validate(Segment{Vec3(0, 0, std::nan("")), Vec3(1, 2, 3)}), Argument::segment);
}

TEST(BallBox, CentersMustBeFiniteAndRadiiNotNegative) {
    EXPECT_NO_THROW(validate(Ball{Vec3(1, 2, 3), -0.0}));
    EXPECT_NO_THROW(validate(Ball{Vec3(1, 2, 3), infinity}));
    for (const double radius : {-0x1p-1074, -1.0, -infinity, std::nan(""), -std::nan("")}) {
        EXPECT_INVALID(validate(Ball{Vec3(1, 2, 3), radius}), Argument::ball) << radius;
    }
    try {
        validate(Ball{Vec3(1, 2, infinity), 1});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::ball);
        EXPECT_EQ(error.part, "center(2)");
        EXPECT_EQ(error.value, infinity);
        EXPECT_STREQ(error.what(), "ball: center, axis 2: coordinate is inf, not finite");
    }
}

// Once, boxes were compared as doubles: where subnormal numbers are taken for zero, an inverted one passed.
TEST(Box, MinimaMustNotBeAboveMaximaInAnyEnvironment) {
    for (const environment::FloatMode& mode : environment::float_modes) {
        const environment::InFloatMode in(mode);
        EXPECT_NO_THROW(validate(Aabb{Vec3(-infinity, -0.0, 1), Vec3(infinity, 0, 1)}));
        EXPECT_NO_THROW(validate(Aabb{Vec3(0.0, 0, 0), Vec3(-0.0, 0x1p-1074, 0)}));
        EXPECT_INVALID(validate(Aabb{Vec3(0, 0x1p-1074, 0), Vec3(0, 0, 0)}), Argument::box) << mode.name;
        EXPECT_INVALID(validate(Aabb{Vec3(0, 0, 0), Vec3(0, 0, -0x1p-1074)}), Argument::box) << mode.name;
        for (const double none : {std::nan(""), -std::nan("")}) {
            EXPECT_INVALID(validate(Aabb{Vec3(none, 0, 0), Vec3(0, 0, 0)}), Argument::box) << mode.name;
            EXPECT_INVALID(validate(Aabb{Vec3(0, 0, 0), Vec3(0, none, 0)}), Argument::box) << mode.name;
        }
    }
}

}  // namespace
}  // namespace ecods::segment_ball_test
