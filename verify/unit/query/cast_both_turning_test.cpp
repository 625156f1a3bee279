// First contacts of two bodies that turn: times that are known, bodies that move as one, all pairs of triangles decided
// one by one, and casts of one turn as turns of both.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/next.hpp"
#include "ecods/builders.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"
#include "environment/each_environment.hpp"
#include "exact/measure/contact/both_turning_triangles.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "geometry/feature_key.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods::cast_both_turning_test {
namespace {

const Turn forth{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, back{{0, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()};

Turn moved(const Turn& turn, const Vec3& by) {
    return {turn.q, turn.pivot_from + by, turn.pivot_to + by};
}

// Asks in both orders.
Contact cast_both(const MeshShape& a, const Turn& turn_a, const MeshShape& b, const Turn& turn_b, double max_time = 1) {
    const Turning<MeshShape> first(a, Pose(), turn_a), second(b, Pose(), turn_b);
    const Contact contact = cast(first, second, max_time), mirrored = cast(second, first, max_time);
    EXPECT_EQ(contact.has_value(), mirrored.has_value());
    if (contact && mirrored) {
        EXPECT_EQ(contact->time, mirrored->time);
        EXPECT_EQ(contact->kind, mirrored->kind);
    }
    return contact;
}

// Two arms turn towards each other by half a turn: their tips, 5 from the pivots, which are 6 apart, are at (3, 4, 0)
// at a third of the time.
TEST(CastBothTurning, TipsMeet) {
    const MeshShape tip = shape_of({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}}),
                    other = shape_of({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
    const Vec3 pivot(6, 0, 0);
    const auto contact = cast_both(tip, forth, other, moved(back, pivot));
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(tip, forth, other, moved(back, pivot), 1 / 3.0));  // the double is below a third
    EXPECT_TRUE(cast_both(tip, forth, other, moved(back, pivot), next_up(1 / 3.0)));
    EXPECT_FALSE(cast_both(tip, forth, other, moved(forth, pivot)));
    // One quaternion, but two axes: the other point stays on its own.
    const MeshShape below = shape_of({{0, -6, 0}, {0, -6, 0}, {0, -6, 0}}), on_axis = shape_of({pivot, pivot, pivot});
    expect_contact(cast_both(below, forth, on_axis, moved(forth, pivot)), 0.5, ClosestKind::vertex_vertex);
    // A bar beside the tip, along the axis.
    const MeshShape bar = shape_of({{1, 0, -1}, {1, 0, 2}, {1, 0, 2}});
    expect_contact(cast_both(tip, forth, bar, moved(back, pivot)), 1 / 3.0, ClosestKind::vertex_edge);
    // Only at the end are both on the line between the pivots, beyond these.
    const MeshShape far = shape_of({{-5, 0, 0}, {-5, 0, 0}, {-5, 0, 0}}),
                    start = shape_of({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}});
    const Turn quarter{{1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()},
        quarter_back{{1, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()};
    expect_contact(cast_both(start, quarter, far, quarter_back), 1, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(start, quarter, far, quarter_back, next_down(1)));
}

// Points on two circles that touch pass the point between them at different times, or at once.
TEST(CastBothTurning, CirclesThatTouch) {
    const Vec3 pivot(10, 0, 0);
    const auto point = [](double x, double y) { return shape_of({{x, y, 0}, {x, y, 0}, {x, y, 0}}); };
    expect_contact(cast_both(point(0, -5), forth, point(10, -5), moved(back, pivot)), 0.5, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(point(0, -5), forth, point(7, -4), moved(back, pivot)));
    // The one leads by the angle of (4, 3).
    EXPECT_FALSE(cast_both(point(3, -4), forth, point(10, -5), moved(back, pivot)));
}

// The teeth of two gears graze: a vertex on its circle touches, at one time, the flat face of a disk's rim that comes
// by; a bit farther away nothing meets.
TEST(CastBothTurning, GearsThatGraze) {
    const auto face_at = [](double x) { return shape_of({{x, -1, -1}, {x, -1, 1}, {x, 3, 0}}); };
    const MeshShape tooth = shape_of({{-3, -4, 0}, {-2, -3, 0}, {-2, -3, 0.5}});
    // The face turns about the same axis at twice the speed, its plane at a distance of 5 from the axis.
    const MeshShape rim = shape_of({{-4, 5, -2}, {-4, 5, 2}, {4, 5, 0}});
    EXPECT_TRUE(cast_both(tooth, forth, rim, back));
    const double above = next_up(5);
    EXPECT_FALSE(cast_both(tooth, forth, shape_of({{-4, above, -2}, {-4, above, 2}, {4, above, 0}}), back));
    // Both faces turn away from each other.
    EXPECT_FALSE(cast_both(face_at(1), forth, face_at(-1), forth));
}

TEST(CastBothTurning, BodiesThatMoveAsOne) {
    const MeshShape ring(scenes::torus(24, 12, 0.25)), ball(scenes::sphere(24, 12));
    const Turn any{{0.3, 0.1, -0.7, 0.5}, {3, 1, 2}, {4, 7, 1}};
    QueryCounts counts;
    const auto ask = [&](const Pose& a, const Turn& turn_a, const Pose& b, const Turn& turn_b) {
        return cast(Turning<MeshShape>(ring, a, turn_a), Turning<MeshShape>(ball, b, turn_b), 1, {counts});
    };
    const Pose away{Mat3::Identity(), Vec3(3, 0, 0)}, near{Mat3::Identity(), Vec3(2, 0, 0)};
    EXPECT_FALSE(ask(Pose(), any, away, any));
    EXPECT_EQ(counts.casts.exact, 0U);
    EXPECT_LT(counts.box_tests, 100U);
    // Along the axis of both, and with a quaternion that is written otherwise.
    const Turn hinge{{1, 0, 0, 1}, {1, 0, 0}, {1, 0, 5}}, other{{1, 0, 0, 1}, {1, 0, 7}, {1, 0, 12}};
    EXPECT_FALSE(ask(Pose(), hinge, away, other));
    const Turn glide{{2, 0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, glide_too{{1, -0.0, 0, 0}, {5, 0, 0}, {6, 1, 0}};
    EXPECT_FALSE(ask(Pose(), glide, away, glide_too));
    EXPECT_EQ(counts.casts.enclosures, 0U);
    EXPECT_EQ(ask(Pose(), any, near, any).value().time, 0);
}

// A door and its handle, and a door on its sill: faces that are in one plane at all times.
TEST(CastBothTurning, Sliding) {
    const MeshShape door = shape_of({{1, 0, 0}, {5, 0, 0}, {5, 0, 3}}),
                    sill = shape_of({{0, 3, 0}, {0, 8, 0}, {0, 6, -1}});
    const Turn quarter{{1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()},
        back_quarter{{1, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()};
    // In the plane of the floor both bottom edges turn towards each other, and meet half-way.
    const auto contact = cast_both(door, quarter, sill, back_quarter);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->time, cast_both(door, {{1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()},
                                       shape_of({{0, 3, 0}, {0, 8, 0}, {0, 6, 0}}), back_quarter)
                                 ->time);
    // On one line with the axis.
    const MeshShape on_axis = shape_of({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}),
                    above = shape_of({{0, 0, 3}, {0, 0, 4}, {0, 0, 4}});
    EXPECT_FALSE(cast_both(on_axis, forth, above, back));
    const Turn down{{0, 0, 0, 1}, Vec3::Zero(), {0, 0, -2}};
    expect_contact(cast_both(on_axis, back, above, down), 0.5, ClosestKind::vertex_vertex);
}

TEST(CastBothTurning, StartAndRefusals) {
    const MeshShape a = shape_of(flat), b = shape_of(needle), c = shape_of({{7, 0, 0}, {8, 0, 0}, {7, 1, 0}});
    expect_contact(cast_both(a, forth, b, back), 0, ClosestKind::intersecting);
    const auto refused = [&](const Turn& turn, const std::string& part) {
        for (const bool is_first : {false, true}) {
            try {
                const Turning<MeshShape> bad(a, Pose(), turn), good(c, Pose(), forth);
                static_cast<void>(is_first ? cast(bad, good) : cast(good, bad));
                ADD_FAILURE() << part;
            } catch (const InvalidArgument& error) {
                EXPECT_EQ(error.argument, Argument::turn);
                EXPECT_EQ(error.part, part);
            }
        }
    };
    refused({{0, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q");
    refused({{-1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q");
    refused({{1, std::nan(""), 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q.x");
    refused({{1, 0, 0, 0}, Vec3::Zero(), {0, 0, INFINITY}}, "pivot_to(2)");
    for (const Turn& turn :
         {Turn{{-1, 0, 0, 0x1p-40}, Vec3::Zero(), Vec3::Zero()}, Turn{{1, 0, 0, 0x1p-600}, Vec3::Zero(), Vec3::Zero()},
          Turn{{1, 0, 0, 1}, Vec3(0x1p600, 0, 0), Vec3(0x1p600, 0, 0)}}) {
        EXPECT_THROW(static_cast<void>(cast_both(a, turn, c, forth)), NotSupported);
        EXPECT_THROW(static_cast<void>(cast_both(a, forth, c, turn)), NotSupported);
    }
    EXPECT_THROW(static_cast<void>(cast_both(a, forth, c, back, -1)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(cast_both(a, forth, c, back, std::nan(""))), InvalidArgument);
    const Pose bad{Mat3::Identity(), Vec3(0, NAN, 0)};
    EXPECT_THROW(static_cast<void>(cast(Turning<MeshShape>(a, bad, forth), Turning<MeshShape>(c, Pose(), back))),
                 InvalidArgument);
    // A body beside itself.
    EXPECT_EQ(cast_both(a, forth, a, back).value().time, 0);
}

// One solid inside the other meets it at time 0; the surfaces never meet.
TEST(CastBothTurning, SolidsInside) {
    const auto inner = box(Vec3(1, 1, 1)), outer = box(Vec3(9, 9, 9));
    const Turning<MeshShape> a(*inner, Pose(), forth), b(*outer, Pose(), back);
    expect_contact(cast(a, b), 0, ClosestKind::contained);
}

// The first contact of all pairs of triangles, each decided exactly. The bodies must not meet at the start.
std::optional<FirstContact> of_all_pairs(const Turning<MeshShape>& a, const Turning<MeshShape>& b) {
    const Mesh &x = a.what->mesh(), &y = b.what->mesh();
    const auto integers_of = [](const Quaternion& q) { return exact::TurnIntegers(q.w, {q.x, q.y, q.z}); };
    const exact::TurnIntegers turn_a = integers_of(a.turn.q), turn_b = integers_of(b.turn.q);
    const Pose world;
    std::optional<FirstContact> first;
    for (std::uint32_t i = 0; i < x.triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < y.triangles().size(); ++j) {
            exact::PosedPoints<10> points;
            for (std::size_t k = 0; k < 3; ++k) {
                points[k] = {&a.pose, &x.vertices()[x.triangles()[i][k]]};
                points[3 + k] = {&b.pose, &y.vertices()[y.triangles()[j][k]]};
            }
            points[6] = {&world, &a.turn.pivot_from};
            points[7] = {&world, &a.turn.pivot_to};
            points[8] = {&world, &b.turn.pivot_from};
            points[9] = {&world, &b.turn.pivot_to};
            const auto meeting = exact::with_integers(points, [&](const auto& integers) {
                exact::BothTurningTriangles triangles(integers, turn_a, turn_b);
                return exact::first_meeting(triangles);
            });
            if (!meeting) continue;
            FirstContact contact;
            contact.time = meeting->time;
            exact::name_features(contact, meeting->features, {i, j});
            if (first && (first->time < contact.time || (first->time == contact.time && rank(*first) <= rank(contact))))
                continue;
            first = contact;
        }
    }
    return first;
}

struct Bodies {
    Pose a, b;
    Turn turn_a, turn_b;
};

Bodies any_bodies(scenes::Random& random) {
    const bool is_lattice = random.below(3) == 0;
    const auto vector = [&](double size) {
        const Vec3 v(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
        return is_lattice ? Vec3(v.array().round()) : v;
    };
    const auto turn = [&] {
        const Vec3 v = vector(2), pivot = vector(2), glide = random.below(2) == 0 ? Vec3(Vec3::Zero()) : vector(2);
        const double w = random.below(4) == 0 ? -0.5 : random.uniform(0.25, 1);
        return Turn{{is_lattice || v.isZero() ? 1 : w, v[0], v[1], v[2]}, pivot, pivot + glide};
    };
    const auto pose = [&] {
        return is_lattice ? Pose{Mat3::Identity(), vector(2)} : Pose{random.turned().R, vector(2)};
    };
    return {pose(), pose(), turn(), turn()};
}

TEST(CastBothTurning, FirstOfAllPairs) {
    scenes::Random random(7);
    const MeshShape ball(scenes::sphere(3, 2)), ring(scenes::torus(3, 3, 0.4)), cube(scenes::cube(0.5));
    const std::array<const MeshShape*, 3> shapes{&ball, &ring, &cube};
    int met = 0, missed = 0;
    for (int run = 0; run < 36; ++run) {
        const MeshShape &a = *shapes[random.below(3)], &b = *shapes[random.below(3)];
        const Bodies bodies = any_bodies(random);
        if (intersects({a, bodies.a}, {b, bodies.b})) continue;
        const Turning<MeshShape> first(a, bodies.a, bodies.turn_a), second(b, bodies.b, bodies.turn_b);
        const auto expected = of_all_pairs(first, second);
        EXPECT_EQ(cast(first, second), expected) << run;
        if (run % 4 == 0) {
            EXPECT_EQ(cast(second, first), of_all_pairs(second, first)) << run;
        }
        if (expected) {
            EXPECT_EQ(cast(first, second, next_up(expected->time)), expected);
            EXPECT_FALSE(cast(first, second, next_down(expected->time)));
        }
        if (run % 8 == 0) {
            environment::in_each_environment([&] { return cast(first, second); },
                                             [&](const auto& there, const std::string& where) {
                                                 EXPECT_EQ(there, expected) << run << ' ' << where;
                                             });
        }
        ++(expected ? met : missed);
    }
    EXPECT_GE(met, 8);
    EXPECT_GT(missed, 4);
}

// Where one body has a null turn, or glides only, the cast is that of one turn, bit for bit.
TEST(CastBothTurning, OneTurnOnly) {
    scenes::Random random(8);
    const MeshShape ball(scenes::sphere(6, 4)), ring(scenes::torus(8, 6, 0.4));
    int met = 0;
    for (int run = 0; run < 60; ++run) {
        const Bodies bodies = any_bodies(random);
        const Turning<MeshShape> a(ball, bodies.a, bodies.turn_a);
        const Turn rest{{random.uniform(0.5, 2), 0, 0, 0}, bodies.turn_b.pivot_from, bodies.turn_b.pivot_from};
        const Contact expected = cast(a, {ring, bodies.b});
        EXPECT_EQ(cast(a, Turning<MeshShape>(ring, bodies.b, rest)), expected) << run;
        const Vec3 glide(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const Turn gliding{{1, 0, 0, 0}, Vec3::Zero(), glide};
        EXPECT_EQ(cast(a, Turning<MeshShape>(ring, bodies.b, gliding)), cast(a, glide, {ring, bodies.b})) << run;
        met += expected && expected->time > 0;
    }
    EXPECT_GT(met, 10);
}

// Sizes: a power of two changes nothing.
TEST(CastBothTurning, Scales) {
    for (const int exponent : {-1000, -300, 0, 300, 900}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto at = [&](double x, double y, double z) { return Vec3(unit * Vec3(x, y, z)); };
        const MeshShape tip = shape_of({at(5, 0, 0), at(4, -1, 0), at(4, -1, 1)}),
                        bar = shape_of({at(1, 0, -1), at(1, 0, 2), at(2, -1, 2)});
        expect_contact(cast_both(tip, forth, bar, moved(back, at(6, 0, 0))), 1 / 3.0, ClosestKind::vertex_edge);
    }
}

// Two gears of many triangles: contact exactly where one pair of triangles says, and few exact decisions.
TEST(CastBothTurning, Gears) {
    const MeshShape first(scenes::torus(96, 24, 0.25)), second(scenes::torus(96, 24, 0.25));
    const Turn slow{about({0, 0, 1}, 0.5, {0, 0, 0}).q, {0, 0, 0}, {0.25, 0, 0}},
        fast = about({0.1, 0, 1}, -2, {2.625, 0, 0});
    const Turning<MeshShape> a(first, Pose(), slow), b(second, {Mat3::Identity(), Vec3(2.5625, 0, 0)}, fast);
    QueryCounts counts;
    const auto contact = cast(a, b, 1, {counts});
    ASSERT_TRUE(contact);
    EXPECT_LT(counts.casts.exact, 40U);
    const Pose before_a = pose_at(Pose(), slow, contact->time - 1e-9),
               before_b = pose_at(b.pose, fast, contact->time - 1e-9);
    EXPECT_FALSE(intersects({first, before_a}, {second, before_b}));
    const Pose after_a = pose_at(Pose(), slow, contact->time + 1e-9),
               after_b = pose_at(b.pose, fast, contact->time + 1e-9);
    EXPECT_TRUE(intersects({first, after_a}, {second, after_b}));
}

}  // namespace
}  // namespace ecods::cast_both_turning_test
