// First contacts of a body that goes straight to a pose beside one that turns or is translated: times that are known,
// motions that are others in disguise, and numbers at the limits of doubles.
#include <gtest/gtest.h>

#include <cmath>

#include "base/next.hpp"
#include "ecods/builders.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"
#include "environment/each_environment.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods::cast_straight_test {
namespace {

const Turn forth{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};  // half a turn about z

Pose at(double x, double y, double z) {
    return {Mat3::Identity(), Vec3(x, y, z)};
}

MeshShape point_at(const Vec3& p) {
    return shape_of({p, p, p});
}

struct Moved {
    const MeshShape& shape;
    Pose from;
    Motion motion;
};

// Asks in both orders. If one body turns, the answers are the same but for the order.
Contact cast_both(const Moved& a, const Moved& b, double max_time = 1) {
    const Contact contact = cast({a.shape, a.from}, a.motion, {b.shape, b.from}, b.motion, max_time);
    const Contact other = cast({b.shape, b.from}, b.motion, {a.shape, a.from}, a.motion, max_time);
    EXPECT_EQ(contact.has_value(), other.has_value());
    if (contact && other) {
        EXPECT_EQ(contact->time, other->time);
        EXPECT_EQ(contact->kind, other->kind);
        if (std::holds_alternative<Turn>(a.motion) || std::holds_alternative<Turn>(b.motion)) {
            EXPECT_EQ(contact->a, other->b);
            EXPECT_EQ(contact->b, other->a);
        }
    }
    return contact;
}

// A point 5 from the axis is at (3, 4, 0) at a third of the time, and rises.
const MeshShape tip = point_at({5, 0, 0});
const Moved turning{tip, Pose(), forth};

// Expects a contact at a third of the time, which is above the double: not up to that double.
void expect_third(const Moved& a, const Moved& b, ClosestKind kind) {
    expect_contact(cast_both(a, b), 1 / 3.0, kind);
    EXPECT_FALSE(cast_both(a, b, 1 / 3.0));
    EXPECT_TRUE(cast_both(a, b, next_up(1 / 3.0)));
}

// The other body comes to (3, 4, 0) at a third, or to a plane, a line or an edge through it, and changes on its way.
TEST(CastStraight, TimesOfATurn) {
    Pose twice = at(1, 10, 0);
    twice.R *= 2;
    const MeshShape one = point_at({1, 0, 0});  // at (3, 1, 0), and at (3, 10, 0) at the end
    expect_third(turning, {one, at(2, 1, 0), Straight{twice}}, ClosestKind::vertex_vertex);
    expect_third({tip, Pose(), Turn{{0, 0, 0, 1}, Vec3::Zero(), {0, 0, 3}}},
                 {one, at(2, 1, 0), Straight{{twice.R, {1, 10, 3}}}}, ClosestKind::vertex_vertex);
    // A bar along z through that point, which grows.
    const MeshShape bar = shape_of({{1, 0, -1}, {1, 0, 2}, {1, 0, 2}});
    expect_third(turning, {bar, at(2, 1, 0), Straight{twice}}, ClosestKind::vertex_edge);
    // A face that falls from 10 to -8; that shears about x = 3, too, so that it is higher where the point comes from.
    const MeshShape plate = shape_of({{-20, 0, -20}, {20, 0, -20}, {0, 0, 20}});
    expect_third(turning, {plate, at(0, 10, 0), Straight{at(0, -8, 0)}}, ClosestKind::vertex_face);
    Pose sheared = at(0, -11, 0);
    sheared.R(1, 0) = 1;
    expect_third(turning, {plate, at(0, 10, 0), Straight{sheared}}, ClosestKind::vertex_face);
    // It turns on its way, about the line x = 3 in it, by no rotation, so that its normal is of the second degree.
    Pose tilted = at(3, -8, 0);
    tilted.R.col(0) = Vec3(0.5, 0.5, 0);
    tilted.R.col(2) = Vec3(0, 0, 3);
    expect_third(turning, {plate, at(3, 10, 0), Straight{tilted}}, ClosestKind::vertex_face);
    // The other way round: the face turns, or the edges cross.
    const MeshShape rod = shape_of({{-9, 0, 0}, {9, 0, 0}, {9, 0, 0}}),
                    pole = shape_of({{5, 0, -1}, {5, 0, 2}, {5, 0, 2}});
    expect_third({pole, Pose(), forth}, {rod, at(0, 10, 0), Straight{at(0, -8, 0)}}, ClosestKind::edge_edge);
    expect_third({pole, Pose(), forth}, {rod, at(3, 10, 0), Straight{tilted}}, ClosestKind::edge_edge);
    const MeshShape blade = shape_of({{3, 0, -2}, {9, 0, -2}, {5, 0, 3}});
    expect_third({blade, Pose(), forth}, {one, at(2, 2, 0), Straight{{twice.R, {1, 8, 0}}}}, ClosestKind::vertex_face);
}

TEST(CastStraight, FirstAndLastTimes) {
    // Half a turn ends at (-5, 0, 0).
    const MeshShape zero = point_at({0, 0, 0});
    const Moved end{zero, at(-5, 0, 7), Straight{at(-5, 0, 0)}};
    expect_contact(cast_both(turning, end), 1, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(turning, end, next_down(1)));
    EXPECT_FALSE(cast_both(turning, {zero, at(-5, 0, 7), Straight{at(-5, 0, 0x1p-1000)}}));
    expect_contact(cast_both(turning, {zero, at(5, 0, 0), Straight{at(9, 9, 9)}}), 0, ClosestKind::intersecting);
    // The last pose is the first one: at rest.
    expect_contact(cast_both(turning, {zero, at(3, 4, 0), Straight{at(3, 4, 0)}}), 1 / 3.0, ClosestKind::vertex_vertex);
    const auto inner = box(Vec3(1, 1, 1)), outer = box(Vec3(9, 9, 9));
    expect_contact(cast_both({*inner, Pose(), forth}, {*outer, Pose(), Straight{at(99, 0, 0)}}), 0,
                   ClosestKind::contained);
    expect_contact(cast_both({*inner, Pose(), Translation{{9, 0, 0}}}, {*outer, Pose(), Straight{at(99, 0, 0)}}), 0,
                   ClosestKind::contained);
}

// A face that is reached, but not crossed: it slides past at the greatest height of the point; it rises at a third as
// fast as the point does, so that two roots are one.
TEST(CastStraight, Grazing) {
    const MeshShape plate = shape_of({{-200, 0, -200}, {200, 0, -200}, {0, 0, 200}});
    const auto slides = [&](double y) { return Moved{plate, at(-1, y, 0), Straight{at(1, y, 3)}}; };
    expect_contact(cast_both(turning, slides(5)), 0.5, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_both(turning, slides(next_up(5))));
    const MeshShape far_tip = point_at({25, 0, 0});
    const auto rises = [&](double by) { return Moved{plate, at(0, 2 + by, 0), Straight{at(3, 56 + by, 0)}}; };
    expect_contact(cast_both({far_tip, Pose(), forth}, rises(0)), 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_both({far_tip, Pose(), forth}, rises(0x1p-40)));
    EXPECT_LT(cast_both({far_tip, Pose(), forth}, rises(-0x1p-40)).value().time, 1 / 3.0);
    // In one plane all the time: a face that turns in its plane, a triangle that shrinks to a point in it.
    const MeshShape disk = shape_of({{1, 0, 0}, {5, -1, 0}, {5, 1, 0}}),
                    patch = shape_of({{-1, 1, 0}, {1, 1, 0}, {0, 2, 0}});
    Pose shrunk = at(0, 4, 0);
    shrunk.R.setZero();
    const auto met = cast_both({disk, Pose(), forth}, {patch, at(0, 4, 0), Straight{shrunk}});
    ASSERT_TRUE(met);
    EXPECT_FALSE(cast_both({disk, Pose(), forth}, {patch, at(0, 4, 0x1p-60), Straight{shrunk}}));
}

// The end of a translation need not be a double: one body ends at 1 - 2^-60, at 1, or beyond.
TEST(CastStraight, EndsThatAreNoDoubles) {
    const MeshShape zero = point_at({0, 0, 0}), one = point_at({1, 0, 0});
    const Moved comes{one, at(-1, 0, 0), Straight{at(0, 0, 0)}};
    const auto ends = [&](double by) { return Moved{zero, at(1, 0, 0), Translation{{by, 0, 0}}}; };
    EXPECT_FALSE(cast_both(comes, ends(0x1p-60)));
    EXPECT_FALSE(cast_both(comes, ends(0x1p-1074)));
    expect_contact(cast_both(comes, ends(-0x1p-60)), 1, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(comes, ends(-0x1p-60), next_down(1)));
    expect_contact(cast_both(comes, ends(-0x1p-1074)), 1, ClosestKind::vertex_vertex);
    expect_contact(cast_both(comes, ends(-0.5)), 2 / 3.0, ClosestKind::vertex_vertex);
    // Beside a turn by nothing it is the same.
    const Turn by{{3, 0, 0, 0}, {0, 0, 0}, {-0x1p-60, 0, 0}};
    expect_contact(cast_both(comes, {zero, at(1, 0, 0), by}), 1, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_both(comes, {zero, at(1, 0, 0), by}, next_down(1)));
}

struct Bodies {
    Pose a, b, to;
    Turn turn;
};

Bodies any_bodies(scenes::Random& random) {
    const auto vector = [&](double size) -> Vec3 {
        const Vec3 v(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
        return (8 * v).array().round() / 8;  // sums are doubles
    };
    const Vec3 axis = vector(2), pivot = vector(2);
    const Turn turn{{axis.isZero() ? 1 : random.uniform(0.25, 1), axis[0], axis[1], axis[2]}, pivot, pivot + vector(1)};
    return {{random.turned().R, vector(3)}, {random.turned().R, vector(3)}, {random.turned().R, vector(3)}, turn};
}

// Moves of which the matrix stays are translations; translations by doubles are straight moves; turns by nothing are
// translations; and times do not change where a straight motion is added to both.
TEST(CastStraight, MotionsInDisguise) {
    scenes::Random random(8);
    const MeshShape ball(scenes::sphere(6, 4)), ring(scenes::torus(8, 6, 0.4));
    int met = 0;
    for (int run = 0; run < 150; ++run) {
        const Bodies bodies = any_bodies(random);
        const Posed<MeshShape> a(ball, bodies.a), b(ring, bodies.b);
        const Vec3 way = bodies.to.t - bodies.b.t;
        const Straight there{{bodies.b.R, bodies.to.t}}, other{bodies.to};
        const Contact beside_turn = cast(a, bodies.turn, b, there);
        EXPECT_EQ(beside_turn, cast(Turning<MeshShape>(ball, bodies.a, bodies.turn), way, b)) << run;
        const Vec3 by = bodies.turn.pivot_to - bodies.turn.pivot_from;
        const Pose end_a{bodies.a.R, bodies.a.t + by};
        const Contact straight = cast(a, Straight{end_a}, b, other);
        EXPECT_EQ(cast(a, Translation{by}, b, other), straight) << run;
        EXPECT_EQ(cast(b, other, a, Translation{by}), cast(b, other, a, Straight{end_a})) << run;
        const Turn glide{{2, 0, 0, 0}, Vec3(1, 2, 3), Vec3(1, 2, 3) + by};
        const Contact of_glide = cast(a, glide, b, other);
        EXPECT_EQ(of_glide.has_value(), straight.has_value()) << run;
        if (of_glide && straight) {
            EXPECT_EQ(of_glide->time, straight->time) << run;
        }
        EXPECT_EQ(cast(a, Translation{by}, b, Translation{way}), cast(a, Straight{end_a}, b, there)) << run;
        met += (beside_turn && beside_turn->time > 0) + (straight && straight->time > 0);
    }
    EXPECT_GT(met, 30);
}

// Answers have equal bits in every rounding mode and instruction set, and from every witness that an answer leaves.
TEST(CastStraight, EnvironmentsAndWitnesses) {
    scenes::Random random(9);
    const MeshShape ball(scenes::sphere(12, 8)), ring(scenes::torus(16, 8, 0.4));
    for (int run = 0; run < 12; ++run) {
        const Bodies bodies = any_bodies(random);
        const Posed<MeshShape> a(ball, bodies.a), b(ring, bodies.b);
        const Motion by = run % 3 == 0 ? Motion(Translation{bodies.turn.pivot_to}) : bodies.turn;
        const auto ask = [&] { return cast(a, by, b, Straight{bodies.to}); };
        const Contact expected = ask();
        environment::in_each_environment(ask, [&](const Contact& there, const std::string& where) {
            EXPECT_EQ(there, expected) << run << ' ' << where;
        });
        if (!expected) continue;
        QueryMemory memory;
        for (PairWitness witness :
             {PairWitness{expected->a.triangle, expected->b.triangle}, PairWitness{0, 0}, PairWitness{0xffffffff, 7}}) {
            EXPECT_EQ(cast(a, by, b, Straight{bodies.to}, 1, {memory, witness}), expected);
            EXPECT_EQ(witness.a, expected->a.triangle);
            EXPECT_EQ(witness.b, expected->b.triangle);
            EXPECT_EQ(cast(b, Straight{bodies.to}, a, by, expected->time, {memory, witness}).has_value(),
                      cast(a, by, b, Straight{bodies.to}, expected->time, {memory, witness}).has_value());
        }
        if (expected->time > 0) {
            EXPECT_FALSE(cast(a, by, b, Straight{bodies.to}, next_down(expected->time)));
        }
    }
}

// A power of two changes nothing. A body may grow or shrink by any factor on its way.
TEST(CastStraight, Scales) {
    for (const int exponent : {-1000, -700, -600, -300, 0, 300, 900}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto scaled = [&](const Pose& pose) { return Pose{pose.R, unit * pose.t}; };
        const MeshShape small_tip = point_at({5 * unit, 0, 0}),
                        plate = shape_of({{-20 * unit, 0, -20 * unit}, {20 * unit, 0, -20 * unit}, {0, 0, 20 * unit}});
        Pose tilted = scaled(at(3, -8, 0));
        tilted.R.col(0) = Vec3(0.5, 0.5, 0);
        expect_third({small_tip, Pose(), forth}, {plate, scaled(at(3, 10, 0)), Straight{tilted}},
                     ClosestKind::vertex_face);
        const Moved falls{plate, scaled(at(3, 10, 0)), Straight{scaled(at(3, -8, 0))}};
        expect_contact(cast_both({small_tip, Pose(), Translation{{0, 0, unit}}}, falls), 5 / 9.0,
                       ClosestKind::vertex_face);
    }
    const MeshShape plate = shape_of({{-20, 0, -20}, {20, 0, -20}, {0, 0, 20}});
    for (const double factor : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
        Pose end = at(0, -8, 0);
        end.R *= factor;
        const Contact met = cast_both(turning, {plate, at(0, 10, 0), Straight{end}});
        if (factor > 1) {
            expect_contact(met, 1 / 3.0, ClosestKind::vertex_face);
        }
        Pose start = at(0, 10, 0);
        start.R *= factor;
        expect_contact(cast_both(turning, {plate, start, Straight{at(0, -8, 0)}}), 1 / 3.0, ClosestKind::vertex_face);
    }
}

// Casts end where numbers are at the limits: far ends, far pivots, points at places below 2^-600.
TEST(CastStraight, Limits) {
    const MeshShape cube(scenes::cube(1)), tiny = point_at({0x1p-700, 0x1p-900, 0}), zero = point_at({0, 0, 0}),
                                           ball(scenes::sphere(12, 8));
    const Turn any{{0.5, 0.25, -0.5, 0.75}, {0x1p-800, 0, 0}, {0, 0x1p-700, 0}};
    for (const double far : {0x1p-1074, 0x1p-900, 0x1p-610, 0x1p-60, 1.0, 0x1p60, 0x1p400}) {
        for (const MeshShape* const shape : {&cube, &tiny, &zero}) {
            Pose end{far * Mat3::Identity(), Vec3(far, -far, 3 * far)};
            static_cast<void>(cast_both({tiny, Pose(), any}, {*shape, at(0, 0, far), Straight{end}}));
            static_cast<void>(cast_both({zero, at(far, 0, 0), forth}, {*shape, at(far, 0, far), Straight{end}}));
            static_cast<void>(cast_both({zero, at(far, 0, 0), Translation{{far, far, far}}},
                                        {*shape, at(far, 0, far), Straight{end}}));
        }
    }
    for (const double far : {0x1p600, 0x1p1023}) {
        EXPECT_FALSE(cast_both(turning, {cube, at(0, 0, 9), Straight{at(far, far, far)}}));
        EXPECT_FALSE(cast_both({cube, at(9, 0, 0), Translation{{-far, 0, 0}}},
                               {cube, at(0, 0, 9), Straight{at(far, far, far)}}));
        EXPECT_FALSE(cast_both({cube, at(9, 0, 0), Translation{{-far, 0, 0}}},
                               {cube, at(0, 0, 9), Straight{at(far, far, far)}}));
        EXPECT_THROW(static_cast<void>(cast_both({cube, at(9, 0, 0), Turn{{1, 0, 0, 1}, {far, 0, 0}, {far, 0, 0}}},
                                                 {cube, at(0, 0, 9), Straight{at(0, 0, 20)}})),
                     NotSupported);
    }
    // Two translations by any length, apart by a number that no double of that size shows.
    const double far = 0x1p900;
    EXPECT_FALSE(cast_both({cube, Pose(), Translation{{far, 0, 0}}}, {cube, at(2.5, 0, 0), Translation{{far, 1, 0}}}));
    expect_contact(cast_both({zero, Pose(), Translation{{far, 2, 0}}}, {zero, at(0, 1, 0), Translation{{far, 0, 0}}}),
                   0.5, ClosestKind::vertex_vertex);
    const Turn refused[] = {{{-1, 0, 0, 0x1p-40}, Vec3::Zero(), Vec3::Zero()},
                            {{1, 0, 0, 0x1p-600}, Vec3::Zero(), Vec3::Zero()}};
    for (const Turn& turn : refused) {
        EXPECT_THROW(
            static_cast<void>(cast_both({cube, at(9, 0, 0), turn}, {cube, at(0, 0, 9), Straight{at(0, 0, 20)}})),
            NotSupported);
    }
    // A small turn about a far pivot is nearly a translation.
    const Turn slow{{1, 0, 0, 0x1p-40}, {0, 0x1p40, 0}, {0, 0x1p40, 0}};
    const Contact turned = cast_both({ball, Pose(), slow}, {cube, at(4, 0, 0), Straight{at(2, 0, 1)}}),
                  moved = cast_both({ball, Pose(), Translation{{2, 0, 0}}}, {cube, at(4, 0, 0), Straight{at(2, 0, 1)}});
    ASSERT_TRUE(turned && moved);
    EXPECT_NEAR(turned->time, moved->time, 1e-9);
}

TEST(CastStraight, BadInput) {
    const MeshShape cube(scenes::cube(1));
    const Posed<MeshShape> a(cube, Pose()), b(cube, at(9, 0, 0));
    const Straight there{at(0, 0, NAN)}, fine{at(0, 9, 0)};
    EXPECT_THROW(static_cast<void>(cast(a, forth, b, there)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(cast(a, there, b, Translation{{1, 0, 0}})), InvalidArgument);
    EXPECT_THROW(static_cast<void>(cast(a, fine, b, Turn{{0, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()})), InvalidArgument);
    EXPECT_THROW(static_cast<void>(cast(a, fine, b, forth, -1)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(cast(a, fine, b, Translation{{1, 0, 0}}, NAN)), InvalidArgument);
}

// Gears' teeth and a rack that tilts: contact where the rigid poses around it say, and few exact decisions.
TEST(CastStraight, ManyTriangles) {
    const MeshShape first(scenes::torus(96, 24, 0.25)), second(scenes::torus(96, 24, 0.25));
    const Turn slow{about({0, 0, 1}, 0.5, {0, 0, 0}).q, {0, 0, 0}, {0.25, 0, 0}};
    Pose from = at(2.75, 0, 0), to = at(2.5, 0.125, 0.25);
    to.R(1, 0) = 0.125;
    to.R(0, 1) = -0.125;
    QueryCounts counts;
    const auto contact = cast({first, Pose()}, slow, {second, from}, Straight{to}, 1, {counts});
    ASSERT_TRUE(contact);
    EXPECT_GT(contact->time, 0);
    EXPECT_LT(counts.casts.exact, 40U);
    const auto meet_at = [&](double s) {
        const Pose b{(1 - s) * from.R + s * to.R, (1 - s) * from.t + s * to.t};
        return intersects({first, pose_at(Pose(), slow, s)}, {second, b});
    };
    EXPECT_FALSE(meet_at(contact->time - 1e-9));
    EXPECT_TRUE(meet_at(contact->time + 1e-9));
}

// A body that goes far, or grows a thousand times, takes about as few pairs as beside a straight motion: its rounding
// at the end says nothing about the beginning, and pieces of the turn are as short as the small body needs.
TEST(CastStraight, FarAndGrowingEnds) {
    const MeshShape ring(scenes::torus(48, 24, 0.25)), ball(scenes::sphere(32, 16));
    const Turn half{{0, 0, 0, 1}, {0, 3, 0}, {0, 3, 0}};
    Pose grown = at(1000, 0, 0);
    grown.R *= 1000;
    for (const Pose& to : {at(-0x1p60, 0x1p58, 0), grown}) {
        QueryCounts counts;
        const auto met = cast({ring, Pose()}, half, {ball, at(3, 0, 0)}, Straight{to}, 1, {counts});
        ASSERT_TRUE(met);
        EXPECT_GT(met->time, 0);
        EXPECT_LT(counts.casts.enclosures, 2000U);
        EXPECT_LT(counts.casts.exact, 200U);
    }
}

}  // namespace
}  // namespace ecods::cast_straight_test
