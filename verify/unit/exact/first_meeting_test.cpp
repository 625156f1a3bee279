// First meetings of two moving triangles: bounds in doubles beside exact ones, and the decision in a short time beside
// the decision in all of it.
#include "exact/measure/contact/first_meeting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/next.hpp"
#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/point/integer_points.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::first_meeting_test {
namespace {

// Corners at the start, then at the end: of the first triangle, then of the second.
using Corners = std::array<Vec3, 12>;

const Pose rest;

PosedPoints<12> posed(const Corners& corners) {
    PosedPoints<12> points;
    for (std::size_t i = 0; i < 12; ++i) points[i] = {&rest, &corners[i]};
    return points;
}

template <class Ask>
auto ask_exactly(const Corners& corners, Ask&& ask) {
    return with_integers(posed(corners), [&](const auto& integers) {
        MovingTriangles triangles(integers);
        return ask(triangles);
    });
}

MovingPoints doubles_of(const Corners& corners) {
    MovingPoints points;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            points.start[i][k] = corners[i][axis];
            points.end[i][k] = corners[6 + i][axis];
        }
    }
    points.start_error = points.end_error = 0x1p-1000;
    return points;
}

// Lattice points, or any near each other, at some scale; some corners stay, and some triangles are flat.
Corners any_corners(scenes::Random& random) {
    Corners corners;
    const bool is_lattice = random.below(2) == 0;
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(3) == 0 ? random.below(1200) : 600) - 600);
    for (Vec3& corner : corners) {
        for (int k = 0; k < 3; ++k) {
            corner[k] = scale * (is_lattice ? static_cast<double>(random.below(7)) - 3 : random.uniform(-1, 1));
        }
    }
    if (random.below(4) == 0) corners[6] = corners[0];
    if (random.below(8) == 0) corners[11] = corners[10];
    return corners;
}

// Makes a corner of the first triangle, or the middle of an edge of it, be half-way where a point of the second is: a
// corner, the middle of an edge, or one inside.
void make_meet(Corners& corners, scenes::Random& random) {
    const auto middle = [&](std::size_t i) { return Vec3(0.5 * corners[i] + 0.5 * corners[6 + i]); };
    const std::uint32_t kind = random.below(3);
    Vec3 target = middle(3);
    if (kind > 0) target = 0.5 * target + 0.5 * middle(4);
    if (kind > 1) target = 0.5 * target + 0.5 * middle(5);
    if (random.below(2) == 0) target = 2 * target - middle(1);
    corners[6] = 2 * target - corners[0];
}

bool start_apart(const Corners& corners) {
    Corners still = corners;
    for (std::size_t i = 0; i < 6; ++i) still[6 + i] = still[i];
    // All is constant, so any features that share a point do so at any root of any polynomial.
    return ask_exactly(still, [](MovingTriangles& triangles) {
        Root half(BinaryFraction{Integer(std::int64_t{1}), 1});
        TrianglesAtRoot then(triangles, half);
        for (const FeaturePair& pair : feature_pairs) {
            if (then.share_point(pair)) return false;
        }
        return true;
    });
}

std::optional<Meeting> meeting_of(const Corners& corners) {
    return ask_exactly(corners, [](MovingTriangles& triangles) { return first_meeting(triangles); });
}

TEST(FirstMeeting, IsNotBeforeItsBounds) {
    scenes::Random random(1);
    int count = 0, fine = 0;
    for (int round = 0; round < 1500; ++round) {
        const Corners corners = any_corners(random);
        const auto meeting = meeting_of(corners);
        const environment::FloatMode& mode =
            environment::float_modes[static_cast<std::size_t>(round) % environment::float_modes.size()];
        for (const Effort effort : {Effort::coarse, Effort::fine}) {
            std::optional<TimeSpan> bound;
            {
                const environment::InFloatMode in_mode(mode);
                bound = bound_first_meeting(doubles_of(corners), 0, 1, effort);
            }
            if (!bound) {
                // If they begin with a common point, what is found later may be anything.
                ASSERT_FALSE(meeting) << round;
                continue;
            }
            ASSERT_LE(0, bound->from);
            ASSERT_LE(bound->from, bound->to);
            ASSERT_LE(bound->to, 1);
            if (!meeting || !start_apart(corners)) continue;
            ASSERT_LE(bound->from, meeting->time) << round;
            ++count;
            fine += meeting->time - bound->from <= 0x1p-40 && effort == Effort::fine;
        }
    }
    EXPECT_GT(count, 500);
    EXPECT_GT(fine, count / 4);
}

// In the cells around a meeting, the features that meet are possible, and what is decided there is what is decided of
// all the time.
TEST(FirstMeeting, InAShortTimeIsTheSame) {
    scenes::Random random(2);
    int count = 0, single = 0;
    for (int round = 0; round < 1500; ++round) {
        const Corners corners = any_corners(random);
        const auto meeting = meeting_of(corners);
        if (!meeting || !start_apart(corners)) continue;
        const double length = std::ldexp(meeting->time, -22 - static_cast<int>(random.below(24)));
        const double part = static_cast<double>(random.below(5)) / 4;
        const TimeSpan around{std::max(0.0, next_down(meeting->time - length * part)),
                              std::min(1.0, next_up(meeting->time + length * (1 - part)))};
        const auto cells = cells_around(around);
        if (!cells) continue;
        const TimeSpan span = cells->span();
        ASSERT_LE(span.from, around.from);
        ASSERT_GE(span.to, around.to);
        ASSERT_LE(span.to, 1);
        ASSERT_LE(span.to - span.from, short_time);
        FeatureSet features = 0;
        {
            const environment::InFloatMode in_mode(
                environment::float_modes[static_cast<std::size_t>(round) % environment::float_modes.size()]);
            features = possible_features(doubles_of(corners), span);
        }
        const auto answer = ask_exactly(
            corners, [&](MovingTriangles& triangles) { return first_meeting_in(triangles, *cells, features); });
        if (!answer.is_known) continue;
        ASSERT_TRUE(answer.meeting) << round;
        ASSERT_EQ(answer.meeting->time, meeting->time) << round;
        ASSERT_EQ(answer.meeting->is_late, meeting->is_late);
        ASSERT_TRUE(answer.meeting->features == meeting->features) << round;
        ++count;
        single += std::has_single_bit(features);
    }
    EXPECT_GT(count, 200);
    EXPECT_GT(single, count / 2);
}

// What two triangles share at one time is possible in any time around it.
TEST(FirstMeeting, FeaturesThatShareAPointArePossible) {
    scenes::Random random(3);
    std::array<int, 4> kinds{};
    for (int round = 0; round < 3000; ++round) {
        Corners corners = any_corners(random);
        make_meet(corners, random);
        const double length = std::ldexp(1.0, -21 - static_cast<int>(random.below(40)));
        FeatureSet features = 0;
        {
            const environment::InFloatMode in_mode(
                environment::float_modes[static_cast<std::size_t>(round) % environment::float_modes.size()]);
            features = possible_features(doubles_of(corners), {0.5 - length / 2, 0.5 + length / 2});
        }
        ask_exactly(corners, [&](MovingTriangles& triangles) {
            Root time(BinaryFraction{Integer(std::int64_t{1}), 1});
            TrianglesAtRoot then(triangles, time);
            for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
                if (!then.share_point(feature_pairs[k])) continue;
                ++kinds[static_cast<std::size_t>(feature_pairs[k].kind)];
                EXPECT_TRUE(features >> k & 1) << round << ' ' << k;
            }
            return true;
        });
    }
    for (const int count : kinds) EXPECT_GT(count, 100);
}

TEST(FirstMeeting, CellsAtTheEndsOfTime) {
    for (const TimeSpan time : {TimeSpan{1, 1}, TimeSpan{next_down(1), 1}, TimeSpan{1 - 0x1p-30, 1 - 0x1p-40},
                                TimeSpan{0, 0x1p-21}, TimeSpan{0, 0x1p-300}, TimeSpan{0.5, 0.5}}) {
        const auto cells = cells_around(time);
        if (time.to == 0x1p-21) {
            EXPECT_FALSE(cells);  // twice as long would be too long
            continue;
        }
        ASSERT_TRUE(cells) << time.from;
        EXPECT_LE(cells->span().from, time.from);
        EXPECT_GE(cells->span().to, time.to);
        EXPECT_LE(cells->span().to, 1);
        EXPECT_LT(cells->span().from, cells->span().to);
    }
    EXPECT_FALSE(cells_around({0, 0x1p-1074}));
    EXPECT_FALSE(cells_around({0, 1}));
}

}  // namespace
}  // namespace ecods::exact::first_meeting_test
