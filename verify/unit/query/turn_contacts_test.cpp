// First contacts of bodies that turn, with times that are known: in each kind of features, grazing, at both ends of
// time, half a turn and more, in one plane or on the axis throughout, between doubles.
#include "ecods/cast.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <numbers>

#include "ecods/solid.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/turn_bodies.hpp"

namespace ecods {
namespace {

std::shared_ptr<const Mesh> box(const Vec3& min, const Vec3& max) {
    return scenes::mapped(*scenes::cube(1), [&](const Vec3& v) -> Vec3 {
        return {v[0] < 0 ? min[0] : max[0], v[1] < 0 ? min[1] : max[1], v[2] < 0 ? min[2] : max[2]};
    });
}

TEST(TurnContacts, EachKindOfFeatures) {
    const Contact on_face = cast_turning(spike, half_turn, first_wall);
    expect_contact(on_face, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(on_face->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(on_face->b, (Feature{Feature::Kind::face, 0, 0}));
    const Contact on_edge = cast_turning(spike, half_turn, {{1.5, 2, 0}, {6, 8, 0}, {3, 4, 3}});
    expect_contact(on_edge, 1 / 3.0, ClosestKind::vertex_edge);
    EXPECT_EQ(on_edge->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(on_edge->b, (Feature{Feature::Kind::edge, 0, 0}));
    expect_contact(cast_turning(spike, half_turn, {{3, 4, 0}, {6, 8, 2}, {6, 8, -2}}), 1 / 3.0,
                   ClosestKind::vertex_vertex);
    expect_contact(cast_turning({{1, 0, 0}, {8, 0, 0}, {4, -1, 0}}, half_turn, {{3, 4, -1}, {3, 4, 1}, {-3, 4, 0}}),
                   1 / 3.0, ClosestKind::edge_edge);
    expect_contact(cast_turning(spike, half_turn, second_wall), 2 / 3.0, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning(spike, half_turn, {{1.5, 2, 1.5}, {1.5, 2, 3}, {6, 8, 1.5}}));  // above
}

TEST(TurnContacts, AtTheStartAndAtTheEnd) {
    expect_contact(cast_turning(spike, half_turn, {{5, 0, 0}, {6, 0, 0}, {5, 5, 5}}), 0, ClosestKind::intersecting);
    expect_contact(cast_turning(spike, half_turn, {{4, 0, -3}, {4, 0, 3}, {9, 0, 0}}), 0, ClosestKind::intersecting);
    expect_contact(cast_turning(spike, half_turn, {{-4, 0, -2}, {-4, 0, 2}, {-8, 0, 0}}), 1, ClosestKind::vertex_face);
    for (const double beyond : {0x1p-1074, 0x1p-60, 0x1p-4}) {
        EXPECT_FALSE(cast_turning(spike, half_turn, {{-4, -beyond, -2}, {-4, -beyond, 2}, {-8, -beyond, 0}}));
    }
    // A third of a turn about (1, 1, 1) ends at (0, r, 0), and has gone up until then.
    const double r = 1e6;
    const std::vector<Vec3> tip{{r, 0, 0}, {r / 2, r / 8, r / 8}, {r / 2, 0, r / 8}};
    const Turn third = about_origin({1, 1, 1, 1});
    const auto ceiling = [&](double y) { return std::vector<Vec3>{{-r, y, -r}, {r, y, -r}, {0, y, 2 * r}}; };
    expect_contact(cast_turning(tip, third, ceiling(r)), 1, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning(tip, third, ceiling(std::nextafter(r, 2 * r))));
    // Just before the end: below the greatest double below 1, half-way to 1, or above that.
    expect_root(cast_turning(spike, half_turn, {{-4, 0x1p-20, -2}, {-4, 0x1p-20, 2}, {-8, 0x1p-20, 0}}),
                {-mpq_class(0x1p-20), 10 + 2 * mpq_class(0x1p-20), -10 - 2 * mpq_class(0x1p-20)});
}

// The tip is at height 10 s (1 - s) / N for N = 1 - 2 s + 2 s^2, which is 5 at half-way and nowhere else.
TEST(TurnContacts, Grazing) {
    const std::vector<Vec3> tip{{5, 0, 0}, {1, 1, 0}, {1, -1, 1}};
    const auto ceiling = [](double y) { return std::vector<Vec3>{{-9, y, -9}, {9, y, -9}, {0, y, 9}}; };
    expect_contact(cast_turning(tip, half_turn, ceiling(5)), 0.5, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning(tip, half_turn, ceiling(std::nextafter(5.0, 6))));
    for (const double below : {std::nextafter(5.0, 0), 5 - 0x1p-30, 4.75, 3.0}) {
        const mpq_class y(below), both = -2 * y - 10;
        const Contact contact = cast_turning(tip, half_turn, ceiling(below));
        expect_root(contact, {y, both, -both});
        EXPECT_LT(contact->time, 0.5);
    }
    // About (1, 1, 1), where x is least after half a turn.
    const std::vector<Vec3> tilted{{3, 0, 0}, {1.5, 0.25, 0.25}, {1.25, 0.5, 0.5}};
    const auto wall = [](double x) { return std::vector<Vec3>{{x, -9, -9}, {x, 9, -9}, {x, 0, 18}}; };
    expect_contact(cast_turning(tilted, about_origin({0, 1, 1, 1}), wall(-1)), 1, ClosestKind::vertex_face);
    expect_contact(cast_turning(tilted, about_origin({-1, 2, 2, 2}), wall(-1)), 0.5, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning(tilted, about_origin({-1, 2, 2, 2}), wall(-1 - 0x1p-52)));
}

// q = (-1, 0, 0, 1) turns by 270 degrees, -q by 90 the other way round; both end at the same rotation.
TEST(TurnContacts, HalfATurnAndMore) {
    const Turn more = about_origin({-1, 0, 0, 1}), less = about_origin({1, 0, 0, -1});
    const std::vector<Vec3> behind{{-1.5, -2, -2}, {-1.5, -2, 2}, {-6, -8, 0}};
    expect_contact(cast_turning(spike, more, behind), 2 / 3.0, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning(spike, half_turn, behind));
    const std::vector<Vec3> sharp{{5, 0, 0}, {4.5, 0, 1}, {4.5, 0, -1}};  // leads both ways
    EXPECT_FALSE(cast_turning(sharp, less, behind));
    const std::vector<Vec3> end{{0, -4, -2}, {0, -4, 2}, {0, -8, 0}};
    expect_contact(cast_turning(sharp, more, end), 1, ClosestKind::vertex_face);
    expect_contact(cast_turning(sharp, less, end), 1, ClosestKind::vertex_face);
    // Nearly a whole turn: twice the angle of (1 - 2 s, e s).
    const double e = 0x1p-20;
    expect_contact(cast_turning(sharp, about_origin({-1, 0, 0, e}), {{-4, 0, -2}, {-4, 0, 2}, {-8, 0, 0}}), 0.5,
                   ClosestKind::vertex_face);
    EXPECT_FALSE(cast_turning({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}}, about_origin({-1, 0, 0, e}),
                              {{4, -0x1p-30, -1}, {4, -0x1p-30, 1}, {6, -0x1p-30, 0}}));
    // Where the quaternion is short, most of the turn takes little time.
    for (const double short_part : {0x1p-5, 0x1p-6, 0x1p-10, 0x1p-28}) {
        expect_contact(cast_turning(sharp, about_origin({-1, 0, 0, short_part}), {{-4, 0, -2}, {-4, 0, 2}, {-8, 0, 0}}),
                       0.5, ClosestKind::vertex_face);
    }
    // Mirrored directions: half a turn the other way round.
    EXPECT_FALSE(cast_turning(sharp, about_origin({0, 0, 0, -1}), first_wall));
    expect_contact(cast_turning(sharp, about_origin({0, 0, 0, -1}), {{1.5, -2, -2}, {1.5, -2, 2}, {6, -8, 0}}), 1 / 3.0,
                   ClosestKind::vertex_face);
}

// A factor k on q takes s / (1 - s) to s / (1 - s) / k; the order of events stays.
TEST(TurnContacts, AFactorOnTheQuaternion) {
    const std::array<std::array<double, 3>, 5> known{{{2, 1 / 5.0, 1 / 2.0},
                                                      {4, 1 / 9.0, 1 / 3.0},
                                                      {0.5, 1 / 2.0, 4 / 5.0},
                                                      {0.25, 2 / 3.0, 8 / 9.0},
                                                      {1, 1 / 3.0, 2 / 3.0}}};
    for (const auto& [k, first, second] : known) {
        const Turn turn = about_origin({0, 0, 0, k});
        expect_contact(cast_turning(spike, turn, first_wall), first, ClosestKind::vertex_face);
        expect_contact(cast_turning(spike, turn, second_wall), second, ClosestKind::vertex_face);
    }
    // 2^-500 / 2, but for a part of 2^-500; s = 1 - 2^-500, rounded.
    expect_contact(cast_turning(spike, about_origin({0, 0, 0, 0x1p500}), first_wall), 0x1p-501,
                   ClosestKind::vertex_face);
    expect_contact(cast_turning(spike, about_origin({0, 0, 0, 0x1p-500}), first_wall), 1, ClosestKind::vertex_face);
}

TEST(TurnContacts, InOnePlaneAndOnTheAxis) {
    expect_contact(cast_turning({{5, 0, 0}, {4, -1, 0}, {3, -1, 0}}, half_turn, {{3, 4, 0}, {6, 8, 0}, {0, 12, 0}}),
                   1 / 3.0, ClosestKind::vertex_vertex);
    expect_contact(cast_turning({{5, 0, 0}, {4, -1, 0}, {3, -1, 0}}, half_turn, {{1.5, 2, 0}, {6, 8, 0}, {0, 12, 0}}),
                   1 / 3.0, ClosestKind::vertex_edge);
    // A point and a segment in that plane; a point on the axis, which glides.
    expect_contact(cast_turning({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, half_turn, {{-2, 0, 0}, {-0.5, 0, 0}, {-2, 0, 0}}),
                   1, ClosestKind::vertex_edge);
    const std::vector<Vec3> above{{0, 0, 1}, {1, 0, 2}, {0, 1, 2}};
    const Quaternion q{0.5, 0, 0, -0.5};
    expect_contact(cast_turning(single_point, with_glide(q, {0, 0, 2.5}), above), 0.4, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_turning(single_point, with_glide(q, {0, 0, 0.75}), above));
    expect_contact(cast_turning(single_point, with_glide(q, {0, 0, 1}), above), 1, ClosestKind::vertex_vertex);
    // All on the axis, which nothing leaves.
    EXPECT_FALSE(cast_turning({{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}, half_turn, {{0, 0, 2}, {0, 0, 3}, {0, 0, 2}}));
    expect_contact(
        cast_turning({{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}, with_glide(q, {0, 0, 3}), {{0, 0, 2}, {0, 0, 3}, {0, 0, 2}}),
        1 / 3.0, ClosestKind::vertex_vertex);
}

TEST(TurnContacts, GlidesAndScrews) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    for (const double w : {0x1p-300, 1.0, 3.0, 0x1p300}) {
        QueryMemory memory;
        const Turn down = with_glide({w, 0, 0, 0}, {0, 0, -3});
        const Contact contact = cast(Turning<MeshShape>(a, at(0, 0, 1), down), {b, Pose()}, 1, memory);
        expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    }
    // Up by 1 until 1 / 3: the wall begins there, or a bit higher.
    const auto wall_from = [](double z) { return std::vector<Vec3>{{1.5, 2, z}, {6, 8, z}, {3, 4, z + 3}}; };
    const Turn screw = with_glide({0, 0, 0, 1}, {0, 0, 3});
    const std::vector<Vec3> tip{{5, 0, 0}, {4.5, -0.25, -1}, {4.5, -0.25, -0.5}};
    expect_contact(cast_turning(tip, screw, wall_from(1)), 1 / 3.0, ClosestKind::vertex_edge);
    expect_contact(cast_turning(tip, screw, wall_from(1 - 0x1p-50)), 1 / 3.0, ClosestKind::vertex_face);
    const Contact later = cast_turning(tip, screw, wall_from(1 + 0x1p-50));
    EXPECT_TRUE(!later || later->time > 1 / 3.0);
    // The pivot goes by (1, -1, 0) until 1 / 3, when a half-plane about it reaches the point at (1, -1, 0) + (3, 4, 0):
    // a face, an edge that crosses another one, and a segment in one plane with the point.
    const Turn across = with_glide({0, 0, 0, 1}, {3, -3, 0});
    const Vec3 p(4, 3, 0);
    expect_contact(cast_turning({{2, 0, -2}, {2, 0, 2}, {9, 0, 0}}, across, {p, p, p}), 1 / 3.0,
                   ClosestKind::vertex_face);
    expect_contact(cast_turning({{2, 0, 0}, {9, 0, 0}, {2, 0, 0}}, across, {p - Vec3(0, 0, 1), p + Vec3(0, 0, 1), p}),
                   1 / 3.0, ClosestKind::vertex_edge);
    expect_contact(cast_turning({{2, 0, 0}, {9, 0, 0}, {2, 0, 0}}, across,
                                {p - Vec3(0, 0, 1), p + Vec3(0, 0, 1), p + Vec3(0, 0, 2)}),
                   1 / 3.0, ClosestKind::edge_edge);
    expect_contact(cast_turning({{2, 0, 0}, {9, 0, 0}, {2, 0, 0}}, across, {p, p, p}), 1 / 3.0,
                   ClosestKind::vertex_edge);
    // The end of the pivot's way is where it is said to be, though the difference is not a double.
    QueryMemory memory;
    const Turn long_way{{1, 0, 0, 0}, {0, 0, 0x1p-60}, {0, 0, -1}};
    const Contact end = cast(Turning<MeshShape>(a, at(0, 0, 1), long_way), {b, Pose()}, 1, memory);
    expect_root(end, {1, -1 - mpq_class(0x1p-60)});
}

// The nearest corner (x, y) of a post meets the front of a rod of half width t about the origin, or of a door, at the
// root of (y - t) - 2 x s - (y + t) s^2.
TEST(TurnContacts, RodsAndDoors) {
    const auto front = [](double x, double y, double t) {
        const mpq_class exact_y(y), exact_t(t);
        return std::vector<mpq_class>{exact_y - exact_t, -2 * mpq_class(x), -exact_y - exact_t};
    };
    const Turn quarter = about_origin({1, 0, 0, 1});
    const MeshShape rod(box({-1, -0.02, -0.02}, {1, 0.02, 0.02}));
    const MeshShape post(box({0.62, 0.62, -1}, {0.66, 0.66, 1}));
    const Contact met = cast_turning(rod, quarter, post);
    expect_root(met, front(0.66, 0.62, 0.02));
    EXPECT_EQ(met->kind, ClosestKind::edge_edge);
    EXPECT_EQ(met->time, 0.3833087872195344);
    const double turned = 2 * std::atan2(met->time, 1.0);
    EXPECT_NEAR(turned / (std::numbers::pi / 2), 0.46605038236695, 1e-14);
    // The bottoms of a door and of a block are in one plane all the way; so are that of the door and a step's top.
    const MeshShape door(box({0, 0, 0}, {1, 0x1p-5, 2})), block(box({0.5, 0.5, 0}, {0.625, 0.625, 0.125}));
    const Contact stopped = cast_turning(door, quarter, block);
    expect_root(stopped, {15, -40, -17});
    EXPECT_EQ(stopped->kind, ClosestKind::vertex_edge);
    const MeshShape step(box({0, 0.5, -1}, {1, 1, 0}));
    expect_root(cast_turning(door, quarter, step), {-15, 64, -17});  // the door's corner at y = 1 / 2
    EXPECT_FALSE(cast_turning(door, quarter, MeshShape(box({0, 0.5, -1}, {1, 1, -0x1p-60}))));
    EXPECT_FALSE(cast_turning(door, quarter, MeshShape(box({1, 1, 0}, {2, 2, 1}))));
    expect_contact(cast_turning(door, quarter, MeshShape(box({0.25, -1, 0}, {0.5, 0, 1}))), 0,
                   ClosestKind::intersecting);
}

// Four teeth, and something thin before one of them: the tooth's number is the triangle's.
TEST(TurnContacts, TeethAreNamed) {
    std::vector<Vec3> teeth;
    for (const auto& [x, y] : {std::array{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}) {
        for (const Vec3& p : spike) teeth.push_back({x * p[0] - y * p[1], y * p[0] + x * p[1], p[2]});
    }
    const Turn quarter = about_origin({1, 0, 0, 1});
    const Contact first = cast_turning(teeth, quarter, first_wall);
    expect_contact(first, 0.5, ClosestKind::vertex_face);
    EXPECT_EQ(first->a, (Feature{Feature::Kind::vertex, 0, 0}));
    std::vector<Vec3> wall;
    for (const Vec3& p : first_wall) wall.push_back({-p[1], p[0], p[2]});
    const Contact second = cast_turning(teeth, quarter, wall);
    expect_contact(second, 0.5, ClosestKind::vertex_face);
    EXPECT_EQ(second->a, (Feature{Feature::Kind::vertex, 1, 0}));
    EXPECT_FALSE(cast_turning(teeth, about_origin({1, 0, 0, 0.25}), wall));
}

// A part inside the other body is contact at time 0 for a solid, not for a surface.
TEST(TurnContacts, ASolidThatContainsTheOther) {
    const Solid room(scenes::cube(9));
    const MeshShape surface(scenes::cube(9)), small = shape_of(spike);
    QueryMemory memory;
    const Turn turn = about_origin({1, 0, 0, 1});
    expect_contact(cast(Turning<MeshShape>(small, Pose(), turn), {room, Pose()}, 1, memory), 0, ClosestKind::contained);
    expect_contact(cast(Turning<MeshShape>(room, Pose(), turn), {small, Pose()}, 1, memory), 0, ClosestKind::contained);
    EXPECT_FALSE(cast(Turning<MeshShape>(small, Pose(), turn), {surface, Pose()}, 1, memory));
    const MeshShape beside = shape_of({{12, 0, 0}, {12, 1, 0}, {12, 0, 1}});
    EXPECT_EQ(cast(Turning<MeshShape>(beside, Pose(), turn), {room, Pose()}, 1, memory),
              cast(Turning<MeshShape>(beside, Pose(), turn), {surface, Pose()}, 1, memory));
}

TEST(TurnContacts, AnyRoundingMode) {
    const std::vector<Vec3> tip{{5, 0, 0}, {1, 1, 0}, {1, -1, 1}}, ceiling{{-9, 3, -9}, {9, 3, -9}, {0, 3, 9}};
    const MeshShape a = shape_of(tip), b = shape_of(ceiling);
    QueryMemory memory;
    const Contact expected = cast(Turning<MeshShape>(a, Pose(), half_turn), {b, Pose()}, 1, memory);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const Contact contact = cast(Turning<MeshShape>(a, Pose(), half_turn), {b, Pose()}, 1, memory);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(contact, expected);
    }
}

}  // namespace
}  // namespace ecods
