// Where bodies that turn, or move from pose to pose, first touch, and along which normal.
#include <gtest/gtest.h>

#include <cmath>

#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "judge/way_questions.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/each_case.hpp"
#include "unit/query/turn_bodies.hpp"

namespace ecods {
namespace {

ContactPoint place_of(const std::vector<Vec3>& a, const Turn& turn, const std::vector<Vec3>& b, ClosestKind kind) {
    const MeshShape shape_a = shape_of(a), shape_b = shape_of(b);
    const Turning<MeshShape> turning(shape_a, Pose(), turn);
    const Contact contact = cast(turning, {shape_b, Pose()});
    EXPECT_TRUE(contact && contact->kind == kind);
    if (!contact) return {};
    return contact_point(turning, {shape_b, Pose()}, *contact);
}

TEST(TurnPlace, OfEachKind) {
    const ContactPoint in_face =
        place_of(spike, half_turn, {{1.5, 2, -2}, {1.5, 2, 2}, {6, 8, 0}}, ClosestKind::vertex_face);
    EXPECT_EQ(in_face.point, Vec3(3, 4, 0));
    EXPECT_EQ(in_face.normal, Vec3(-0.8, 0.6, 0));  // the way the tip goes
    // A face that turns onto a corner at rest.
    const ContactPoint of_face = place_of({{2, 0, -2}, {2, 0, 2}, {9, 0, 0}}, half_turn,
                                          {{3, 4, 0}, {2.5, 5, 0.5}, {2.5, 5, -0.5}}, ClosestKind::vertex_face);
    EXPECT_EQ(of_face.point, Vec3(3, 4, 0));
    EXPECT_EQ(of_face.normal, Vec3(-0.8, 0.6, 0));
    // An edge along the axis crosses one that goes outwards.
    const ContactPoint edges = place_of({{5, 0, -1}, {5, 0, 1}, {4.75, -0.5, 0}}, half_turn,
                                        {{1.5, 2, 0.25}, {6, 8, 0.25}, {3, 9, 0.25}}, ClosestKind::edge_edge);
    EXPECT_EQ(edges.point, Vec3(3, 4, 0.25));
    EXPECT_EQ(edges.normal, Vec3(-0.8, 0.6, 0));
    const ContactPoint tips =
        place_of(spike, half_turn, {{3, 4, 0}, {1, 5, 1}, {1, 5, -1}}, ClosestKind::vertex_vertex);
    EXPECT_EQ(tips.point, Vec3(3, 4, 0));
    EXPECT_FALSE(tips.normal);
}

// Beside a body that is translated, the point is where both are then.
TEST(TurnPlace, BesideATranslation) {
    const MeshShape a = shape_of(spike), b = shape_of({{1.5, 2, -5}, {1.5, 2, -1}, {6, 8, -3}});
    const Turning<MeshShape> turning(a, Pose(), half_turn);
    const Vec3 motion(0, 0, 9);
    const Contact contact = cast(turning, motion, {b, Pose()});
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->time, 1 / 3.0);
    const ContactPoint place = contact_point(turning, motion, {b, Pose()}, *contact);
    EXPECT_EQ(place.point, Vec3(3, 4, 0));
    EXPECT_EQ(place.normal, Vec3(-0.8, 0.6, 0));
}

TEST(TurnPlace, OfStraightMotions) {
    const MeshShape tip = shape_of(needle), sheet = shape_of({{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}});
    const Moving<MeshShape> down(tip, {Mat3::Identity(), Vec3(0.25, 0, 1)}, {Mat3::Identity(), Vec3(0.25, 1, -2)}),
        rest(sheet, Pose(), Pose());
    const Contact contact = cast(down, rest);
    ASSERT_TRUE(contact);
    const ContactPoint place = contact_point(down, rest, *contact);
    EXPECT_EQ(place.point, Vec3(0.25, 1 / 3.0, 0));
    EXPECT_EQ(place.normal, Vec3(0, 0, -1));
    const Contact other = cast(rest, down);
    ASSERT_TRUE(other);
    EXPECT_EQ(contact_point(rest, down, *other).normal, Vec3(0, 0, 1));
    int judged = 0;
    QueryMemory memory;
    scenes::for_each_case(scenes::move_families(), 4, 12, [&](const scenes::MoveCase& made) {
        const MeshShape a(made.a), b(made.b);
        const Moving<MeshShape> first(a, made.from_a, made.to_a), second(b, made.from_b, made.to_b);
        const auto wrong = judge::ask_about_point(first, second, memory);
        EXPECT_FALSE(wrong) << wrong->question << ": " << wrong->expected << ", not " << wrong->got;
        judged += cast(first, second, 1, memory).has_value();
    });
    EXPECT_GT(judged, 30);
}

TEST(TurnPlace, AtTheStartAndOfOthersContacts) {
    const MeshShape a = shape_of(flat), b = shape_of(needle), wall = shape_of(first_wall), tip = shape_of(spike);
    const Turning<MeshShape> at_start(a, Pose(), half_turn), turning(tip, Pose(), half_turn);
    const Contact touching = cast(at_start, {b, Pose()});
    ASSERT_TRUE(touching && touching->time == 0);
    EXPECT_EQ(contact_point(at_start, {b, Pose()}, *touching), (ContactPoint{Vec3::Zero(), {}}));
    const Contact contact = cast(turning, {wall, Pose()});
    ASSERT_TRUE(contact);
    const auto refused = [&](const FirstContact& other) {
        EXPECT_THROW(static_cast<void>(contact_point(turning, {wall, Pose()}, other)), NotSupported);
    };
    for (int which = 0; which < 5; ++which) {
        FirstContact other = *contact;
        if (which == 0) other.time = std::nextafter(other.time, 1);
        if (which == 1) other.a.triangle = 7;
        if (which == 2) other.a.corner = 3;
        if (which == 3) other.kind = ClosestKind::edge_edge;
        if (which == 4) other.a.corner = 1;
        refused(other);
    }
    const Way<MeshShape> way(tip, Pose(), {{{}, Vec3::Zero()}, {half_turn.q, Vec3::Zero()}});
    EXPECT_THROW(static_cast<void>(contact_point(way, {wall, Pose()}, {1, *contact})), NotSupported);
    EXPECT_EQ(contact_point(way, {wall, Pose()}, {0, *contact}), contact_point(turning, {wall, Pose()}, *contact));
    EXPECT_THROW(static_cast<void>(contact_point({tip, Pose(), about_origin({0, 0, 0, 0})}, {wall, Pose()}, *contact)),
                 InvalidArgument);
}

}  // namespace
}  // namespace ecods
