// The oracle's first contacts of bodies that turn: answers made by hand, and its two ways, by roots of polynomials and
// by pieces of the time, against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/first_contact.hpp"
#include "oracle/turn_subdivision.hpp"
#include "scenes/each_case.hpp"
#include "scenes/turn_cases.hpp"

namespace ecods::oracle::oracle_turn_test {
namespace {

Soup soup(const Mesh& mesh, const Pose& pose) {
    return {mesh.vertices(), mesh.triangles(), pose};
}

TurningSoup turning(const scenes::TurnCase& made) {
    const auto& [w, x, y, z] = made.turn.q;
    return {soup(*made.a, made.pose_a), {w, x, y, z}, made.turn.pivot_from, made.turn.pivot_to};
}

using Corners = std::vector<Vec3>;

scenes::TurnCase triangles(const Corners& a, const Corners& b, const Turn& turn) {
    return {Mesh::create(a, {{0, 1, 2}}), Mesh::create(b, {{0, 1, 2}}), {}, {}, turn};
}

Turn about_origin(const Quaternion& q) {
    return {q, Vec3::Zero(), Vec3::Zero()};
}

// Both ways give the time and the kind.
void expect(const scenes::TurnCase& made, const mpq_class& time, Closeness kind) {
    const TurningSoup a = turning(made);
    const Soup b = soup(*made.b, made.pose_b);
    const auto contact = first_contact(a, b);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->time.compare(time), 0) << contact->rounded;
    EXPECT_EQ(contact->kind, kind);
    EXPECT_EQ(contradiction(a, b, contact).value_or(""), "");
    const TurnSubdivision pieces(a, b);
    EXPECT_TRUE(pieces.meet(time));
    EXPECT_TRUE(time == 0 || pieces.are_apart(0, time * mpq_class(1023, 1024), 30));
    EXPECT_FALSE(pieces.are_apart(0, time, 30));
}

void expect_apart(const scenes::TurnCase& made) {
    const TurningSoup a = turning(made);
    const Soup b = soup(*made.b, made.pose_b);
    EXPECT_FALSE(first_contact(a, b));
    EXPECT_EQ(contradiction(a, b, std::nullopt).value_or(""), "");
}

// Half a turn about the z axis takes (5, 0, 0) to (3, 4, 0) at 1 / 3, and to (-3, 4, 0) at 2 / 3.
const Turn half_turn = about_origin({0, 0, 0, 1});
const Corners spike{{5, 0, 0}, {4.5, -0.25, 1}, {4.5, -0.25, -1}};

TEST(OracleTurn, OfASpike) {
    expect(triangles(spike, {{1.5, 2, -2}, {1.5, 2, 2}, {6, 8, 0}}, half_turn), {1, 3}, Closeness::vertex_face);
    expect(triangles(spike, {{1.5, 2, 0}, {6, 8, 0}, {3, 4, 3}}, half_turn), {1, 3}, Closeness::vertex_edge);
    expect(triangles(spike, {{3, 4, 0}, {6, 8, 2}, {6, 8, -2}}, half_turn), {1, 3}, Closeness::vertex_vertex);
    expect(triangles(spike, {{-1.5, 2, -2}, {-1.5, 2, 2}, {-6, 8, 0}}, half_turn), {2, 3}, Closeness::vertex_face);
    expect(triangles(spike, {{-4, 0, -2}, {-4, 0, 2}, {-8, 0, 0}}, half_turn), 1, Closeness::vertex_face);
    expect_apart(triangles(spike, {{-4, -0x1p-40, -2}, {-4, -0x1p-40, 2}, {-8, -0x1p-40, 0}}, half_turn));
    // The other way round, and more than half a turn.
    const Corners wall{{-1.5, -2, -2}, {-1.5, -2, 2}, {-6, -8, 0}};
    expect_apart(triangles(spike, wall, half_turn));
    const Corners ahead{{5, 0, 0}, {4.5, 0.25, 1}, {4.5, 0.25, -1}};
    expect(triangles(ahead, wall, about_origin({0, 0, 0, -1})), {2, 3}, Closeness::vertex_face);
    expect(triangles(spike, wall, about_origin({-1, 0, 0, 1})), {2, 3}, Closeness::vertex_face);
    // A factor of 2 on q: 1 / 5 for 1 / 3.
    expect(triangles(spike, {{1.5, 2, -2}, {1.5, 2, 2}, {6, 8, 0}}, about_origin({0, 0, 0, 2})), {1, 5},
           Closeness::vertex_face);
}

TEST(OracleTurn, OfEdgesPlanesAndPoints) {
    // An edge on the x axis comes first to the nearer one of two edges.
    expect(triangles({{1, 0, 0}, {8, 0, 0}, {4, -1, 0}}, {{3, 4, -1}, {3, 4, 1}, {-3, 4, 0}}, half_turn), {1, 3},
           Closeness::edge_edge);
    // The farthest point grazes a plane half-way.
    const Corners far_tip{{5, 0, 0}, {1, 1, 0}, {1, -1, 1}};
    expect(triangles(far_tip, {{-9, 5, -9}, {9, 5, -9}, {0, 5, 9}}, half_turn), {1, 2}, Closeness::vertex_face);
    expect_apart(triangles(far_tip, {{-9, 5 + 0x1p-50, -9}, {9, 5 + 0x1p-50, -9}, {0, 5 + 0x1p-50, 9}}, half_turn));
    // All in one plane; a point and a segment; a point on the axis, which glides.
    expect(triangles({{5, 0, 0}, {4, -1, 0}, {3, -1, 0}}, {{3, 4, 0}, {6, 8, 0}, {0, 12, 0}}, half_turn), {1, 3},
           Closeness::vertex_vertex);
    expect(triangles({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{-2, 0, 0}, {-0.5, 0, 0}, {-2, 0, 0}}, half_turn), 1,
           Closeness::vertex_edge);
    expect(triangles({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {1, 0, 2}, {0, 1, 2}},
                     {{0.5, 0, 0, -0.5}, {0, 0, 0}, {0, 0, 2.5}}),
           {2, 5}, Closeness::vertex_vertex);
    expect(triangles(spike, {{5, 0, 0}, {6, 0, 0}, {5, 5, 5}}, half_turn), 0, Closeness::intersecting);
    // About (1, 1, 1), at the end.
    expect(triangles({{3, 0, 0}, {1.5, 0.25, 0.25}, {1.25, 0.5, 0.5}}, {{-1, -9, -9}, {-1, 9, -9}, {-1, 0, 18}},
                     about_origin({0, 1, 1, 1})),
           1, Closeness::vertex_face);
}

// Both ways find the same in every family; recipes know some times.
TEST(OracleTurn, BothWaysAgree) {
    int met = 0, known = 0, apart = 0;
    scenes::for_each_case(scenes::turn_families(), 1, 12, [&](const scenes::TurnCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > 9) return;
        const TurningSoup a = turning(made);
        const Soup b = soup(*made.b, made.pose_b);
        const auto contact = first_contact(a, b);
        if (made.time) {
            ++known;
            ASSERT_EQ(contact ? contact->rounded : -1, *made.time);
        }
        ++(contact ? met : apart);
        ASSERT_EQ(contradiction(a, b, contact).value_or(""), "") << (contact ? contact->rounded : -1);
    });
    EXPECT_GT(met, 30);
    EXPECT_GT(apart, 10);
    EXPECT_GT(known, 10);
}

// A time that is not the first, and a contact that is none, are found out.
TEST(OracleTurn, WrongTimesAreFound) {
    const scenes::TurnCase made = triangles(spike, {{1.5, 2, -2}, {1.5, 2, 2}, {6, 8, 0}}, half_turn);
    const TurningSoup a = turning(made);
    const Soup b = soup(*made.b, made.pose_b);
    auto contact = first_contact(a, b);
    ASSERT_TRUE(contact);
    EXPECT_FALSE(contradiction(a, b, contact));
    EXPECT_TRUE(contradiction(a, b, std::nullopt));
    for (const double wrong : {std::nextafter(contact->rounded, 0), std::nextafter(contact->rounded, 1)}) {
        ExactContact other = *contact;
        other.rounded = wrong;
        other.time = Root(mpq_class(wrong));
        EXPECT_TRUE(contradiction(a, b, other)) << wrong;
    }
}

}  // namespace
}  // namespace ecods::oracle::oracle_turn_test
