// Casts between poses at their limits: times that are as small as doubles are, limits of time, translations, short
// stacks, and what an exact decision may cost.
#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <tuple>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/cast.hpp"
#include "environment/each_environment.hpp"
#include "judge/cast_truth.hpp"
#include "query/cast/cast_until.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods::cast_moving_limits_test {
namespace {

// Chords of gaps whose zeros underflow, in floats or in doubles: a triangle of the size of one is met at a time of
// 2^-130, 2^-1000, 2^-1074 or less, and is left soon after.
TEST(CastMovingLimits, TinyTimes) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    for (const double height : {0x1p-30, 0x1p-75, 0x1p-200, 0x1p-500, 0x1p-1000}) {
        for (const double way : {0x1p0, 0x1p100, 0x1p500, 0x1p1000}) {
            // At height / (height + way), which rounds to height / way.
            const int exponent = std::ilogb(height) - std::ilogb(way);
            if (exponent > -60) continue;
            const double time = std::ldexp(1.0, std::max(exponent, -1074));
            const Moving<MeshShape> from_a(a, at(0, 0, height), at(way, 0, -way)), from_b(b, Pose(), Pose());
            const auto ask = [&] {
                QueryMemory memory;
                return std::pair(cast(from_a, from_b, 1, memory), cast(from_b, from_a, 1, memory));
            };
            environment::in_each_environment(ask, [&](const auto& contacts, const std::string& where) {
                const auto& [contact, swapped] = contacts;
                ASSERT_TRUE(contact && swapped) << where << ' ' << height << ' ' << way;
                EXPECT_EQ(key_of(contact->time), key_of(time)) << where << ' ' << height << ' ' << way;
                EXPECT_EQ(key_of(swapped->time), key_of(time)) << where << ' ' << height << ' ' << way;
            });
        }
    }
}

// At most 1 / 3, which is no double; and at most a half, which is one.
TEST(CastMovingLimits, ALimitIsDecidedForTheRealTime) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    const Moving<MeshShape> still(b, Pose(), Pose());
    const auto until = [&](const Moving<MeshShape>& moving, double at_most) {
        QueryMemory memory;
        PairWitness witness;
        const auto contact = cast_until(moving, still, at_most, memory, witness);
        const auto again = cast_until(moving, still, at_most, memory, witness);
        EXPECT_EQ(contact, again);
        const auto all = cast(moving, still, 1, memory);
        EXPECT_TRUE(!contact || contact == all);
        return contact.has_value();
    };
    const Moving<MeshShape> third(a, at(0, 0, 1), at(0, 0, -2)), half(a, at(0, 0, 1), at(0, 0, -1)),
        two_thirds(a, at(0, 0, 2), at(0, 0, -1)), at_start(a, at(0, 0, 0), at(0, 0, 1));
    const double of_third = 1 / 3.0, of_two_thirds = 2 / 3.0;  // below and above
    EXPECT_FALSE(until(third, of_third));
    EXPECT_TRUE(until(third, next_up(of_third)));
    EXPECT_FALSE(until(third, next_down(of_third)));
    EXPECT_TRUE(until(two_thirds, of_two_thirds) == (3 * mpq_class(of_two_thirds) >= 2));
    EXPECT_FALSE(until(two_thirds, next_down(of_two_thirds)));
    EXPECT_TRUE(until(half, 0.5));
    EXPECT_FALSE(until(half, next_down(0.5)));
    EXPECT_FALSE(until(half, 0));
    EXPECT_TRUE(until(at_start, 0));
    EXPECT_TRUE(until(at_start, -0.0));
    EXPECT_TRUE(until(third, 1));
}

// A vertex falls on faces that lie above each other by less than doubles know of them where they are: each is met at a
// time of its own, though in the order of their bounds the last may come first.
TEST(CastMovingLimits, FacesCloserThanRounding) {
    const MeshShape a = shape_of(needle);
    for (int top = 0; top < 8; ++top) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 8; ++i) {
            const double height = std::ldexp(1.0, 10) - std::ldexp((i - top + 8) % 8, -42);
            for (const Vec3& corner : flat) corners.push_back(corner + Vec3(0, 0, height));
        }
        const MeshShape b = shape_of(corners);
        QueryMemory memory;
        const auto contact = cast(Moving<MeshShape>(a, at(0, 0, 1), at(0, 0, -1)),
                                  Moving<MeshShape>(b, at(0, 0, -0x1p10), at(0, 0, -0x1p10)), 1, memory);
        ASSERT_TRUE(contact);
        EXPECT_EQ(contact->time, 0.5) << top;
        EXPECT_EQ(contact->triangles(), (TrianglePair{0, static_cast<std::uint32_t>(top)}));
    }
}

// Where nothing but t changes, and by a vector that is a double, the two casts are one question.
TEST(CastMovingLimits, AsATranslation) {
    scenes::Random random(5);
    QueryMemory memory;
    int contacts = 0, starts = 0;
    for (int round = 0; round < 1500; ++round) {
        const bool is_lattice = round % 2 == 0;
        const auto number = [&] {
            const double x = random.uniform(-2, 2);
            return is_lattice ? std::round(x) : std::ldexp(std::round(std::ldexp(x, 30)), -30);
        };
        std::vector<Vec3> u, v;
        for (int i = 0; i < 6; ++i) u.push_back({number(), number(), number()});
        for (int i = 0; i < 9; ++i) v.push_back({number(), number(), number()});
        const MeshShape a = shape_of(u), b = shape_of(v);
        Pose pose_a = at(3 * number(), number(), number()), pose_b = at(number(), number(), number());
        if (round % 3 == 0) pose_a.R = random.rotation().toRotationMatrix();
        if (round % 5 == 0) pose_b.R(1, 1) = 0;
        const Vec3 motion = -2 * pose_a.t + Vec3(number(), number(), number());
        Pose to = pose_a;
        to.t += motion;
        ASSERT_EQ(to.t - pose_a.t, motion);
        const auto slide = cast({a, pose_a}, motion, {b, pose_b}, 1, memory);
        const Moving<MeshShape> moving(a, pose_a, to), still(b, pose_b, pose_b);
        const auto move = cast(moving, still, 1, memory);
        ASSERT_TRUE(judge::is_same(move, slide)) << round << ": " << judge::text(move) << ", " << judge::text(slide);
        auto swapped = cast(still, moving, 1, memory);
        ASSERT_EQ(swapped.has_value(), move.has_value());
        // In equal motion nothing happens.
        const auto together = cast(moving, Moving<MeshShape>(b, pose_b, {pose_b.R, pose_b.t + motion}), 1, memory);
        const bool start = intersects({a, pose_a}, {b, pose_b}, memory);
        ASSERT_EQ(together.has_value(), start) << round;
        contacts += move.has_value();
        starts += start;
    }
    EXPECT_GT(contacts, 500);
    EXPECT_GT(starts, 20);
    EXPECT_LT(starts, contacts / 2);
}

// Poses that are equal at both ends.
TEST(CastMovingLimits, AtRestAsIntersects) {
    scenes::Random random(6);
    QueryMemory memory;
    int contacts = 0;
    scenes::for_each_case(scenes::move_families(), random, 40, [&](const scenes::MoveCase& made) {
        const MeshShape a(made.a), b(made.b);
        const auto contact = cast(Moving<MeshShape>(a, made.from_a, made.from_a),
                                  Moving<MeshShape>(b, made.from_b, made.from_b), 1, memory);
        const Posed<MeshShape> still_a(a, made.from_a), still_b(b, made.from_b);
        ASSERT_EQ(contact.has_value(), intersects(still_a, still_b, memory));
        if (!contact) return;
        ++contacts;
        EXPECT_EQ(contact->time, 0);
        EXPECT_EQ(contact->kind, ClosestKind::intersecting);
        EXPECT_EQ(contact->triangles(), intersecting_triangles(still_a, still_b, memory).front());
    });
    EXPECT_GT(contacts, 20);
}

// Two bodies apart that become 2^1650 times as large, and go farther from each other: whatever happens does so at times
// that round to the least double, where bounds must not be lost. Otherwise all pairs of triangles are asked exactly.
TEST(CastMovingLimits, BodiesThatGrowImmensely) {
    const MeshShape a(scenes::torus(12, 8, 0.25)), b(scenes::sphere(8, 6));
    Pose from_a, to_a, from_b = at(0, 0, 0x1.8p1), to_b = at(0, 0, 0x1p2);
    to_a.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    for (Pose* pose : {&from_a, &from_b}) *pose = Pose{0x1p-800 * pose->R, 0x1p-800 * pose->t};
    for (Pose* pose : {&to_a, &to_b}) *pose = Pose{0x1p850 * pose->R, 0x1p850 * pose->t};
    const auto ask = [&] {
        QueryMemory memory;
        const auto contact = cast(Moving<MeshShape>(a, from_a, to_a), Moving<MeshShape>(b, from_b, to_b), 1, memory);
        return std::pair(contact, memory.counts().casts.exact);
    };
    environment::in_each_environment(ask, [](const auto& answer, const std::string& where) {
        EXPECT_FALSE(answer.first) << where;
        EXPECT_EQ(answer.second, 0U) << where;
    });
}

// The widest integers, and all polynomials of two triangles, on a stack of half a MiB.
TEST(CastMovingLimits, ShortStacks) {
    const auto ask = [](void* is_asked) -> void* {
        const MeshShape a = shape_of({{0x1p-1000, 0x1p1000, 1}, {-0x1p1000, 0, 0}, {1, 0x1p-500, -1}}),
                        b = shape_of({{0, 0, 3}, {0x1p900, 3, 3}, {0, 0x1p-900, 0x1p500}});
        Pose from, to;
        from.R *= 0x1p20;
        to.R *= -0x1p-1000;
        to.R(0, 2) = 0x1p-1074;
        to.t = {1, 0x1p-1074, 0x1p1000};
        QueryMemory memory;
        std::ignore = cast(Moving<MeshShape>(a, from, to), Moving<MeshShape>(b, to, from), 1, memory);
        *static_cast<bool*>(is_asked) = memory.counts().casts.exact > 0;
        return nullptr;
    };
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{1} << 19), 0);
    pthread_t thread;
    bool is_asked = false;  // in integers
    ASSERT_EQ(pthread_create(&thread, &attributes, ask, &is_asked), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    EXPECT_TRUE(is_asked);
}

}  // namespace
}  // namespace ecods::cast_moving_limits_test
