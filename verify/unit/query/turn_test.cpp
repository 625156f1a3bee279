// Turns: how they are made, which are refused and why, and what is computed of them, beside numbers of 50 digits.
#include "ecods/turn.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cfenv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::turn_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Reals = std::array<Real, 3>;
using Rows = std::array<Reals, 3>;

const double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();
const Real pi = boost::math::constants::pi<Real>();

// The distance of two doubles in units of the last place of the second.
double ulps(const Real& x, double rounded) {
    const Real ulp = Real(std::nextafter(std::abs(rounded), infinity)) - Real(std::abs(rounded));
    return static_cast<double>(abs((x - Real(rounded)) / ulp));
}

Rows rotation(const Real& w, const Real& x, const Real& y, const Real& z) {
    const Real n = w * w + x * x + y * y + z * z;
    return {{{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
             {2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n},
             {2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
}

// Where the turn takes a point of the world.
Reals place(const Turn& turn, const Real& s, const Reals& p) {
    const Quaternion& q = turn.q;
    const Rows R = rotation(1 + s * (Real(q.w) - 1), s * Real(q.x), s * Real(q.y), s * Real(q.z));
    Reals result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real from(turn.pivot_from[static_cast<int>(k)]), to(turn.pivot_to[static_cast<int>(k)]);
        result[k] = from + s * (to - from);
        for (std::size_t i = 0; i < 3; ++i) result[k] += R[k][i] * (p[i] - Real(turn.pivot_from[static_cast<int>(i)]));
    }
    return result;
}

Reals posed(const Pose& pose, const Vec3& v) {
    Reals p;
    for (int k = 0; k < 3; ++k) {
        p[static_cast<std::size_t>(k)] = Real(pose.t[k]);
        for (int i = 0; i < 3; ++i) p[static_cast<std::size_t>(k)] += Real(pose.R(k, i)) * Real(v[i]);
    }
    return p;
}

Real distance(const Reals& p, const Reals& q) {
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

Real angle_of(const Turn& turn, const Real& s) {
    const Quaternion& q = turn.q;
    const Real length = sqrt(Real(q.x) * q.x + Real(q.y) * q.y + Real(q.z) * q.z);
    return 2 * atan2(s * length, (1 - s) + s * Real(q.w));  // exact at 1, however small w is
}

Turn turn_of(const Quaternion& q, const Vec3& from = Vec3::Zero(), const Vec3& to = Vec3::Zero()) {
    return {q, from, to};
}

Turn any_turn(scenes::Random& random) {
    const auto q = random.rotation();
    const double size = std::ldexp(1.0, static_cast<int>(random.below(5)) - 2), share = random.below(3) == 0 ? 1e-6 : 1;
    return {{size * q.w(), share * size * q.x(), share * size * q.y(), share * size * q.z()},
            random.direction(),
            random.direction()};
}

template <class Call>
std::string part_of(const Call& call) {
    try {
        call();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::turn) << error.what();
        return error.part;
    }
    return "not refused";
}

TEST(Turns, RefusedWithTheirReason) {
    const auto why = [](const Turn& turn) {
        const MeshShape shape(scenes::cube(1));
        const std::string part = part_of([&] { validate(turn); });
        EXPECT_EQ(part, part_of([&] {
                      static_cast<void>(cast(Turning<MeshShape>(shape, Pose(), turn), {shape, Pose()}));
                  }));
        EXPECT_EQ(part, part_of([&] { static_cast<void>(angle_at(turn, 0.5)); }));
        EXPECT_EQ(part, part_of([&] { static_cast<void>(time_at(turn, 0.5)); }));
        EXPECT_EQ(part, part_of([&] { static_cast<void>(pose_at(Pose(), turn, 0.5)); }));
        EXPECT_EQ(part, part_of([&] { static_cast<void>(end_gap(shape, Pose(), turn, Pose())); }));
        return part;
    };
    EXPECT_EQ(why(turn_of({0, 0, 0, 0})), "q");
    EXPECT_EQ(why(turn_of({-1, 0, 0, 0})), "q");
    EXPECT_EQ(why(turn_of({-0x1p-1074, -0.0, 0, 0})), "q");
    EXPECT_EQ(why(turn_of({nan, 0, 0, 1})), "q.w");
    EXPECT_EQ(why(turn_of({1, infinity, 0, 1})), "q.x");
    EXPECT_EQ(why(turn_of({1, 0, -infinity, 1})), "q.y");
    EXPECT_EQ(why(turn_of({1, 0, 0, nan})), "q.z");
    EXPECT_EQ(why(turn_of({}, {0, nan, 0})), "pivot_from(1)");
    EXPECT_EQ(why(turn_of({}, {0, 0, 0}, {0, 0, infinity})), "pivot_to(2)");
    for (const Quaternion& q :
         {Quaternion{0x1p-1074, 0, 0, 0}, {0, 0, 0, 0x1p-1074}, {-0x1p1023, 0, 0, 0x1p-1074}, {1, 0x1p1023, 0, 0}}) {
        EXPECT_NO_THROW(validate(Turn{q, Vec3::Zero(), Vec3::Zero()}));
    }
}

// Where doubles say nothing, a cast does not decide all pairs of triangles exactly, which might never end.
TEST(Turns, ThoseThatDoublesCannotFollowAreRefused) {
    const MeshShape shape(scenes::cube(1));
    const auto ask = [&](const Quaternion& q, const Vec3& pivot) {
        return cast(Turning<MeshShape>(shape, Pose(), Turn{q, pivot, pivot}), {shape, {Mat3::Identity(), {9, 9, 9}}});
    };
    EXPECT_THROW(static_cast<void>(ask({-1, 0, 0, 0x1p-30}, Vec3::Zero())), NotSupported);
    EXPECT_THROW(static_cast<void>(ask({1, 0, 0, 0x1p-501}, Vec3::Zero())), NotSupported);
    EXPECT_THROW(static_cast<void>(ask({1, 0, 0x1p501, 0}, Vec3::Zero())), NotSupported);
    EXPECT_THROW(static_cast<void>(ask({1, 0, 0, 1}, {0x1p505, 0, 0})), NotSupported);
    for (const double far : {0.0, 0x1p40, 0x1p300, 0x1p490}) {
        for (const Quaternion& q : {Quaternion{1, 0, 0, 1}, {1, 0, 0, 0x1p-499}, {-1, 0, 0, 0x1p-28}}) {
            EXPECT_EQ(ask(q, {far, 0, 0}), std::nullopt) << far << ", " << q.z;
        }
    }
}

TEST(Turns, OtherArgumentsAreRefused) {
    const MeshShape shape(scenes::cube(1));
    const Turn turn{{1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    const Turning<MeshShape> a(shape, Pose(), turn);
    Pose bad;
    bad.R(1, 1) = nan;
    EXPECT_INVALID(cast(a, {shape, Pose()}, -1), Argument::time);
    EXPECT_INVALID(cast(a, {shape, Pose()}, nan), Argument::time);
    EXPECT_INVALID(angle_at(turn, -0x1p-1074), Argument::time);
    EXPECT_INVALID(angle_at(turn, std::nextafter(1.0, 2)), Argument::time);
    EXPECT_INVALID(angle_at(turn, nan), Argument::time);
    EXPECT_INVALID(pose_at(Pose(), turn, 2), Argument::time);
    EXPECT_INVALID(pose_at(bad, turn, 0.5), Argument::pose);
    EXPECT_EQ(part_of([&] { static_cast<void>(time_at(turn, -1)); }), "angle");
    EXPECT_EQ(part_of([&] { static_cast<void>(time_at(turn, nan)); }), "angle");
    EXPECT_EQ(part_of([&] { static_cast<void>(about({0, 0, 0}, 1, {0, 0, 0})); }), "axis");
    EXPECT_EQ(part_of([&] { static_cast<void>(about({nan, 0, 0}, 1, {0, 0, 0})); }), "axis(0)");
    EXPECT_EQ(part_of([&] { static_cast<void>(about({1, 0, 0}, 1, {0, 0, infinity})); }), "pivot(2)");
    for (const double angle : {nan, infinity, 2 * std::acos(-1.0) + 1e-9, -7.0}) {
        EXPECT_EQ(part_of([&] { static_cast<void>(about({1, 0, 0}, angle, {0, 0, 0})); }), "angle") << angle;
    }
    Pose mirror;
    mirror.R(0, 0) = -1;
    Pose flat;
    flat.R.col(0).setZero();
    EXPECT_INVALID(between(Pose(), mirror, {0, 0, 0}), Argument::pose);
    EXPECT_INVALID(between(flat, Pose(), {0, 0, 0}), Argument::pose);
    EXPECT_INVALID(between(Pose(), bad, {0, 0, 0}), Argument::pose);
    EXPECT_NO_THROW(static_cast<void>(between(mirror, mirror, {0, 0, 0})));
}

// The axis and the half angle are those of the quaternion, up to rounding.
TEST(Turns, AboutAnAxis) {
    scenes::Random random(1);
    for (int i = 0; i < 400; ++i) {
        const Vec3 axis = std::ldexp(1.0, static_cast<int>(random.below(1800)) - 900) * random.direction();
        const double angle = i % 4 == 0 ? random.uniform(-6.283, 6.283) : std::ldexp(random.uniform(-6, 6), -(i % 200));
        const Turn turn = about(axis, angle, {1, 2, 3});
        EXPECT_EQ(turn.pivot_from, Vec3(1, 2, 3));
        EXPECT_EQ(turn.pivot_to, Vec3(1, 2, 3));
        const Real length = sqrt(Real(axis[0]) * axis[0] + Real(axis[1]) * axis[1] + Real(axis[2]) * axis[2]);
        const Real half = Real(angle) / 2, sine = sin(half);
        const std::array<double, 4> q{turn.q.w, turn.q.x, turn.q.y, turn.q.z};
        const std::array<Real, 4> exact{cos(half), sine * axis[0] / length, sine * axis[1] / length,
                                        sine * axis[2] / length};
        // A length of its own is allowed: components are compared in the ratio of the largest.
        const Real scale = sqrt(Real(q[0]) * q[0] + Real(q[1]) * q[1] + Real(q[2]) * q[2] + Real(q[3]) * q[3]);
        for (std::size_t k = 0; k < 4; ++k) {
            const Real off = abs(Real(q[k]) / scale - exact[k]);
            EXPECT_LE(off, (k == 0 ? Real(1) : abs(sine)) * Real(0x1p-51)) << i << ' ' << k;
        }
    }
    EXPECT_EQ(about({0, 0, 1}, 0, {0, 0, 0}).q.z, 0);
    EXPECT_NO_THROW(validate(about({0, 0, 1}, 0, {0, 0, 0})));
    const Turn nearly_whole = about({0, 0, 2}, std::nextafter(2 * std::acos(-1.0), 0), {0, 0, 0});
    EXPECT_LT(nearly_whole.q.w, 0);
    EXPECT_NO_THROW(validate(nearly_whole));
}

TEST(Turns, AngleAndTime) {
    scenes::Random random(2);
    for (int i = 0; i < 400; ++i) {
        const Turn turn = any_turn(random);
        const double time = i % 3 == 0 ? std::ldexp(random.uniform(0.5, 1), -(i % 60)) : random.uniform(0, 1);
        const double angle = angle_at(turn, time);
        EXPECT_LE(ulps(angle_of(turn, Real(time)), angle), 2) << i;
        const double part = random.uniform(0, 1) * angle_at(turn, 1);
        const double reached = time_at(turn, part);
        const Quaternion& q = turn.q;
        const Real length = sqrt(Real(q.x) * q.x + Real(q.y) * q.y + Real(q.z) * q.z), half = Real(part) / 2;
        const Real exact = part == 0 ? Real(0) : 1 / (1 - Real(q.w) + length * cos(half) / sin(half));
        EXPECT_LE(ulps(exact, reached), 2) << i << ' ' << part;
    }
}

TEST(Turns, AngleAndTimeAtTheEnds) {
    const Turn quarter{{1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}}, half{{0, 0, 3, 4}, {0, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(angle_at(quarter, 0), 0);
    EXPECT_LE(ulps(pi / 2, angle_at(quarter, 1)), 2);
    EXPECT_LE(ulps(pi, angle_at(half, 1)), 2);
    EXPECT_EQ(time_at(quarter, 0), 0);
    EXPECT_EQ(time_at(quarter, 4), 1);
    EXPECT_EQ(time_at(quarter, infinity), 1);
    const Turn glide{{2, 0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(angle_at(glide, 0.5), 0);
    EXPECT_EQ(time_at(glide, 0), 0);
    EXPECT_EQ(time_at(glide, 0x1p-1074), 1);
    for (const Quaternion& q : {Quaternion{1, 0, 0, 0x1p-1000},
                                {-1, 0x1p-600, 0, 0},
                                {0x1p900, 0, 0x1p900, 0},
                                {0x1p-900, 0, 0, 0x1p-1000},
                                {0, 0x1p-1074, 0, 0}}) {
        const Turn turn{q, Vec3::Zero(), Vec3::Zero()};
        for (const double s : {0x1p-300, 0.25, 0.5, 1 - 0x1p-40, 1.0}) {
            const Real exact = angle_of(turn, Real(s));
            if (exact < Real(0x1p-1000)) continue;
            EXPECT_LE(ulps(exact, angle_at(turn, s)), 2) << s;
        }
    }
}

// From one double to the next, and the same bits in every rounding mode.
TEST(Turns, AngleAndTimeAreMonotone) {
    scenes::Random random(3);
    for (int i = 0; i < 40; ++i) {
        const Turn turn = any_turn(random);
        double time = random.uniform(0.01, 0.99), angle = random.uniform(0.01, 0.99) * angle_at(turn, 1);
        double last_angle = 0, last_time = 0;
        for (int k = 0; k < 24; ++k) {
            const double next_angle = angle_at(turn, time), next_time = time_at(turn, angle);
            EXPECT_GE(next_angle, last_angle);
            EXPECT_GE(next_time, last_time);
            const int mode =
                std::array{FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}[static_cast<std::size_t>(k % 4)];
            std::fesetround(mode);
            const double other_angle = angle_at(turn, time), other_time = time_at(turn, angle);
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(other_angle, next_angle);
            EXPECT_EQ(other_time, next_time);
            last_angle = next_angle;
            last_time = next_time;
            time = std::nextafter(time, 1);
            angle = std::nextafter(angle, 7);
        }
    }
}

TEST(Turns, PosesOnTheWay) {
    scenes::Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Turn turn = any_turn(random);
        Pose start = random.turned();
        start.t = random.direction();
        const double time = i == 0 ? 0 : i == 1 ? 1 : random.uniform(0, 1);
        const Pose pose = pose_at(start, turn, time);
        for (const Vec3& v : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
            EXPECT_LE(distance(posed(pose, v), place(turn, Real(time), posed(start, v))), Real(0x1p-49)) << i;
        }
    }
    Pose start = scenes::Random(5).turned();
    EXPECT_EQ(pose_at(start, {{1, 0, 0, 1}, {1, 2, 3}, {1, 2, 3}}, 0), start);
}

// The turn between two poses ends near the second, the short way, and its pivot is that of the body.
TEST(Turns, BetweenPoses) {
    scenes::Random random(6);
    const MeshShape shape(scenes::cube(1));
    for (int i = 0; i < 200; ++i) {
        Pose from = random.turned(), to = random.turned();
        if (i % 4 == 0) to.R = from.R;
        from.t = random.direction();
        to.t = 3 * random.direction();
        const Vec3 pivot = random.direction();
        const Turn turn = between(from, to, pivot);
        EXPECT_NO_THROW(validate(turn));
        EXPECT_GE(turn.q.w, 0) << i;
        const Reals start = posed(from, pivot), end = posed(to, pivot);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(abs(start[k] - Real(turn.pivot_from[static_cast<int>(k)])), Real(0x1p-50));
            EXPECT_LE(abs(end[k] - Real(turn.pivot_to[static_cast<int>(k)])), Real(0x1p-50));
        }
        Real farthest = 0;
        for (const Vec3& v : shape.mesh().vertices()) {
            farthest = std::max(farthest, distance(place(turn, 1, posed(from, v)), posed(to, v)));
        }
        const double gap = end_gap(shape, from, turn, to);
        EXPECT_GE(Real(gap), farthest) << i;
        EXPECT_LE(gap, 0x1p-46) << i;
        // A bound where the end is elsewhere, too.
        const Pose other{to.R, to.t + Vec3(0.25, 0, 0)};
        const double far_gap = end_gap(shape, from, turn, other);
        EXPECT_GE(far_gap, 0.25 - 0x1p-46);
        EXPECT_LE(far_gap, 0.25 + 0x1p-44);
    }
    // Half a turn about each axis, and the other poses of a cube.
    for (const Vec3& axis : {Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
        const Pose to{axis.asDiagonal(), Vec3(1, 2, 3)};
        const Turn turn = between(Pose(), to, {0, 0, 0});
        EXPECT_EQ(turn.q.w, 0);
        EXPECT_LE(end_gap(shape, Pose(), turn, to), 0x1p-46);
    }
    // A gap whose square overflows, also where it rounds down to the largest double.
    std::fesetround(FE_DOWNWARD);
    const double far = end_gap(shape, Pose(), turn_of({1, 0, 0, 1}), Pose{Mat3::Identity(), Vec3(0x1p700, 0, 0)});
    std::fesetround(FE_TONEAREST);
    EXPECT_GE(far, 0x1p700);
}

}  // namespace
}  // namespace ecods::turn_test
