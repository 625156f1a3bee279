// First contacts of translated bodies with times that are known: in each kind of features, in one plane, grazing, at
// both ends of time, between doubles, at any scale.
#include "ecods/cast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/next.hpp"
#include "cast_bodies.hpp"
#include "ecods/error.hpp"
#include "environment/float_mode.hpp"
#include "query/cast/cast_until.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

Pose scaled(double scale) {
    Pose pose;
    pose.R *= scale;
    return pose;
}

// In either order, with any witness, in any floating-point environment, and with limits around the rounded time.
Contact contact_of(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b) {
    QueryMemory memory;
    const Contact contact = cast(a, motion, b, 1, memory);
    const Contact other = cast(b, -motion, a, 1, memory);
    EXPECT_EQ(contact.has_value(), other.has_value());
    if (contact && other) {
        EXPECT_EQ(contact->time, other->time);
        EXPECT_EQ(contact->kind, other->kind);
    }
    for (const PairWitness first : {PairWitness{}, PairWitness{0, 0}, PairWitness{7, 0}}) {
        PairWitness witness = first;
        for (int turn = 0; turn < 2; ++turn) {
            EXPECT_EQ(cast(a, motion, b, 1, {memory, witness}), contact);
            if (contact) {
                EXPECT_EQ(witness.a, contact->a.triangle);
                EXPECT_EQ(witness.b, contact->b.triangle);
            }
        }
    }
    for (const environment::FloatMode& mode : environment::float_modes) {
        Contact same;
        {
            const environment::InFloatMode in_mode(mode);
            QueryMemory of_its_own;
            same = cast(a, motion, b, 1, of_its_own);
        }
        EXPECT_EQ(same, contact) << mode.name;
    }
    if (contact && contact->time < 1) {
        PairWitness witness;
        EXPECT_EQ(cast_until(a, motion, b, next_up(contact->time), memory, witness), contact);
    }
    if (contact && contact->time > 0) {
        PairWitness witness;
        EXPECT_FALSE(cast_until(a, motion, b, next_down(contact->time), memory, witness));
    }
    return contact;
}

TEST(Cast, VertexMeetsFace) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    const Contact contact = contact_of({a, at(0, 0, 1)}, {0, 0, -3}, {b, {}});
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 0, 0}));
    const Contact other = contact_of({b, {}}, {0, 0, 3}, {a, at(0, 0, 1)});
    expect_contact(other, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(other->a, (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(other->b, (Feature{Feature::Kind::vertex, 0, 0}));
}

TEST(Cast, VertexMeetsEdgeAndVertex) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    const Contact edge = contact_of({a, at(0, -1, 1)}, {0, 0, -7}, {b, {}});
    expect_contact(edge, 1 / 7.0, ClosestKind::vertex_edge);
    EXPECT_EQ(edge->b, (Feature{Feature::Kind::edge, 0, 0}));
    const Contact vertex = contact_of({a, at(2, -1, 1)}, {0, 0, -7}, {b, {}});
    expect_contact(vertex, 1 / 7.0, ClosestKind::vertex_vertex);
    EXPECT_EQ(vertex->b, (Feature{Feature::Kind::vertex, 0, 1}));
}

TEST(Cast, EdgesCross) {
    const MeshShape a = shape_of({{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}), b = shape_of({{0, -1, 0}, {0, 1, 0}, {0, 0, -1}});
    const Contact contact = contact_of({a, at(0.25, 0.125, 1)}, {0, 0, -3}, {b, {}});
    expect_contact(contact, 1 / 3.0, ClosestKind::edge_edge);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::edge, 0, 0}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::edge, 0, 0}));
}

// Faces in parallel planes: corners of the one in the other, edges that cross, and all of both.
TEST(Cast, FacesMeet) {
    const MeshShape a = shape_of(flat), b = shape_of(flat);
    expect_contact(contact_of({a, at(0.25, 0.5, 1)}, {0, 0, -4}, {b, {}}), 0.25, ClosestKind::vertex_face);
    expect_contact(contact_of({a, at(0, 0, 1)}, {0, 0, -4}, {b, {}}), 0.25, ClosestKind::vertex_vertex);
    const MeshShape star = shape_of({{1, 1, 0}, {-2, 1, 0}, {1, -2, 0}}),
                    small = shape_of({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}});
    expect_contact(contact_of({star, at(0, 0, 1)}, {0, 0, -4}, {small, {}}), 0.25, ClosestKind::vertex_edge);
    const MeshShape wide = shape_of({{-3, -1, 0}, {3, -1, 0}, {0, 2, 0}}),
                    turned = shape_of({{-3, 1, 0}, {3, 1, 0}, {0, -2, 0}});
    expect_contact(contact_of({wide, at(0, 0, 1)}, {0, 0, -4}, {turned, {}}), 0.25, ClosestKind::edge_edge);
}

TEST(Cast, InOnePlane) {
    const MeshShape a = shape_of({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}}),
                    b = shape_of({{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}});
    expect_contact(contact_of({a, at(1, 0, 0)}, {-3, 0, 0}, {b, {}}), 1 / 3.0, ClosestKind::vertex_vertex);
    expect_contact(contact_of({a, at(1, 0.5, 0)}, {-7, 0, 0}, {b, {}}), 3 / 14.0, ClosestKind::vertex_edge);
    EXPECT_FALSE(contact_of({a, at(1, 3, 0)}, {-3, 0, 0}, {b, {}}));
    // Past each other, edge along edge, and a hair beside that.
    expect_contact(contact_of({a, at(3, 2, 0)}, {-8, 0, 0}, {b, {}}), 5 / 8.0, ClosestKind::vertex_vertex);
    EXPECT_FALSE(contact_of({a, at(3, next_up(2), 0)}, {-8, 0, 0}, {b, {}}));
}

TEST(Cast, OnOneLine) {
    const MeshShape a = shape_of({{0, 0, 0}, {1, 2, 3}, {1, 2, 3}}), b = shape_of({{0, 0, 0}, {-1, -2, -3}, {0, 0, 0}});
    const Contact contact = contact_of({a, at(1, 2, 3)}, {-5, -10, -15}, {b, {}});
    expect_contact(contact, 1 / 5.0, ClosestKind::vertex_vertex);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_FALSE(contact_of({a, at(1, 2, next_up(3))}, {-5, -10, -15}, {b, {}}));
}

TEST(Cast, ContactAtBothEnds) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    expect_contact(contact_of({a, at(0, 0, 1)}, {0, 0, -1}, {b, {}}), 1, ClosestKind::vertex_face);
    EXPECT_FALSE(contact_of({a, at(0, 0, 1)}, {0, 0, next_up(-1)}, {b, {}}));
    EXPECT_FALSE(contact_of({a, at(0, 0, next_up(1))}, {0, 0, -1}, {b, {}}));
    expect_contact(contact_of({a, at(0, 0, 0)}, {0, 0, 1}, {b, {}}), 0, ClosestKind::intersecting);
    expect_contact(contact_of({a, at(0, 0, -0.5)}, {0, 0, 3}, {b, {}}), 0, ClosestKind::intersecting);
    // A time above 1 that rounds to it.
    const MeshShape higher = shape_of({{0, 0, 0x1p-60}, {0.25, 0, 1}, {-0.25, 0, 1}});
    EXPECT_FALSE(contact_of({higher, at(0, 0, 1)}, {0, 0, -1}, {b, {}}));
    // Away from each other.
    EXPECT_FALSE(contact_of({a, at(0, 0, 0x1p-1074)}, {0, 0, 1}, {b, {}}));
    EXPECT_FALSE(contact_of({a, at(0, 0, -2)}, {0, 0, -1}, {b, {}}));
}

// A positive time is positive, however small: 2^-1100; and a time half-way between two doubles goes to the even one.
TEST(Cast, TimesBelowTheLeastDouble) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    expect_contact(contact_of({a, at(0, 0, 0x1p-100)}, {0, 0, -0x1p1000}, {b, {}}), 0x1p-1074,
                   ClosestKind::vertex_face);
    expect_contact(contact_of({a, at(0, 0, 0x3p-1074)}, {0, 0, -2}, {b, {}}), 0x1p-1073, ClosestKind::vertex_face);
    expect_contact(contact_of({a, at(0, 0, 0x1p-1074)}, {0, 0, -4}, {b, {}}), 0x1p-1074, ClosestKind::vertex_face);
    expect_contact(contact_of({a, at(0, 0, 0x1p-1074)}, {0, 0, -0x1p-1074}, {b, {}}), 1, ClosestKind::vertex_face);
}

TEST(Cast, NoMotion) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    for (const double zero : {0.0, -0.0}) {
        const Vec3 motion(zero, 0, zero);
        EXPECT_FALSE(contact_of({a, at(0, 0, 0x1p-1074)}, motion, {b, {}}));
        expect_contact(contact_of({a, at(0, 0, zero)}, motion, {b, {}}), 0, ClosestKind::intersecting);
    }
    expect_contact(contact_of({a, at(0, 0, 1)}, {-0.0, -0.0, -2}, {b, {}}), 0.5, ClosestKind::vertex_face);
}

TEST(Cast, MotionsThatAreNotFinite) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    QueryMemory memory;
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_INVALID(cast({a, {}}, Vec3(0, bad, 0), {b, {}}, 1, memory), Argument::motion);
    }
}

// Grazing: a corner goes along a face's border; the double beside it misses.
TEST(Cast, Grazes) {
    const MeshShape a = shape_of(single_point), b = shape_of(flat);
    expect_contact(contact_of({a, at(-3, -1, 0)}, {8, 0, 0}, {b, {}}), 0.25, ClosestKind::vertex_vertex);
    EXPECT_FALSE(contact_of({a, at(-3, next_down(-1), 0)}, {8, 0, 0}, {b, {}}));
    // Through the edge from (-1, -1) to (2, -1), from above to below.
    expect_contact(contact_of({a, at(0, -2, 1)}, {0, 4, -4}, {b, {}}), 0.25, ClosestKind::vertex_edge);
    EXPECT_FALSE(contact_of({a, at(0, -2, next_down(1))}, {0, 4, -4}, {b, {}}));
    // Edge over edge.
    const MeshShape roof = shape_of({{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}});
    const MeshShape rope = shape_of({{0, -9, 0}, {0, 9, 0}, {0, 9, 0}});
    expect_contact(contact_of({rope, at(-4, 0, 0)}, {6, 0, 0}, {roof, {}}), 0.5, ClosestKind::vertex_edge);
    EXPECT_FALSE(contact_of({rope, at(-4, 0, 0x1p-1074)}, {6, 0, 0}, {roof, {}}));
    expect_contact(contact_of({rope, at(-4, 0, 0x1p-60)}, {6, 0, -0x1p-59}, {roof, {}}), 0.5, ClosestKind::vertex_edge);
}

// Bodies, their way, and what is between them, at any scale: a time is a ratio.
TEST(Cast, AtAnyScale) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    for (const int exponent : {-1020, -900, -400, -60, 60, 400, 900, 1000}) {
        SCOPED_TRACE(exponent);
        const double scale = std::ldexp(1.0, exponent);
        Pose start = scaled(scale);
        start.t = {0, 0, scale};
        expect_contact(contact_of({a, start}, {0, 0, -5 * scale}, {b, scaled(scale)}), 1 / 5.0,
                       ClosestKind::vertex_face);
        // A long way, or a short one, of bodies of size one.
        start = at(0, 0, scale);
        expect_contact(contact_of({a, start}, {0, 0, -5 * scale}, {b, {}}), 1 / 5.0, ClosestKind::vertex_face);
        if (exponent < 0) continue;
        // A fast motion over a short way.
        expect_contact(contact_of({a, at(0, 0, 1)}, {0, 0, -scale}, {b, {}}), 1 / scale, ClosestKind::vertex_face);
    }
    // The middle of the largest numbers, and points that are none of them.
    const double most = std::numeric_limits<double>::max();
    Pose far = at(0, 0, most);
    far.R *= 0x1p1000;
    expect_contact(contact_of({a, far}, {0, 0, -most}, {b, scaled(0x1p1000)}), 1, ClosestKind::vertex_face);
    EXPECT_FALSE(contact_of({a, at(0, 0, most)}, {0, 0, -next_down(most)}, {b, at(0, 0, -most)}));
    EXPECT_FALSE(contact_of({a, at(0, 0, most)}, {0, 0, -most}, {b, at(0, 0, -0x1p970)}));
    expect_contact(contact_of({b, at(0, 0, -most)}, {0, 0, most}, {a, {}}), 1, ClosestKind::vertex_face);
}

TEST(Cast, SingularPoses) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    Pose flattened = at(0, 0, 1);
    flattened.R(2, 2) = 0;  // a is the segment from (-1/4, 0, 1) to (1/4, 0, 1)
    const Contact contact = contact_of({a, flattened}, {0, 0, -3}, {b, {}});
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0}));
    Pose nothing = at(0, 0, 1);
    nothing.R.setZero();  // a is a point, whose least corner names it
    const Contact of_point = contact_of({a, nothing}, {0, 0, -3}, {b, {}});
    expect_contact(of_point, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(of_point->a, (Feature{Feature::Kind::vertex, 0, 0}));
    Pose zero;
    zero.R.setZero();
    expect_contact(contact_of({a, nothing}, {0, 0, -7}, {b, zero}), 1 / 7.0, ClosestKind::vertex_vertex);
    EXPECT_FALSE(contact_of({a, nothing}, {0x1p-1074, 0, -7}, {b, zero}));
    Pose mirrored = at(0, 0, 1);
    mirrored.R(0, 0) = -1;
    expect_contact(contact_of({a, mirrored}, {0, 0, -3}, {b, {}}), 1 / 3.0, ClosestKind::vertex_face);
}

// Triangles without area: segments in two ways, and points.
TEST(Cast, ZeroAreaTriangles) {
    const MeshShape segment = shape_of({{0, -2, 0}, {0, 2, 0}, {0, -2, 0}}),
                    b = shape_of({{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), dot = shape_of(single_point);
    const Contact crossing = contact_of({segment, at(0.5, 0, 1)}, {0, 0, -3}, {b, {}});
    expect_contact(crossing, 1 / 3.0, ClosestKind::edge_edge);
    EXPECT_EQ(crossing->a.corner, 0u);
    const Contact on_edge = contact_of({dot, at(0.5, 0, 1)}, {0, 0, -3}, {b, {}});
    expect_contact(on_edge, 1 / 3.0, ClosestKind::vertex_edge);
    EXPECT_EQ(on_edge->b, (Feature{Feature::Kind::edge, 0, 0}));
    expect_contact(contact_of({dot, at(1, 0, 1)}, {0, 0, -3}, {b, {}}), 1 / 3.0, ClosestKind::vertex_vertex);
    expect_contact(contact_of({dot, at(1, 0, 1)}, {0, 0, -3}, {dot, at(1, 0, 0)}), 1 / 3.0, ClosestKind::vertex_vertex);
    EXPECT_FALSE(contact_of({dot, at(1, 0, 1)}, {0x1p-1074, 0, -3}, {dot, at(1, 0, 0)}));
    // Parallel segments, one beside the other in the end.
    expect_contact(contact_of({segment, at(0, 0, 1)}, {0, 1, -3}, {segment, {}}), 1 / 3.0, ClosestKind::vertex_edge);
    expect_contact(contact_of({segment, at(0, 0, 1)}, {0, 12, -3}, {segment, {}}), 1 / 3.0, ClosestKind::vertex_vertex);
}

TEST(Cast, EqualBodies) {
    const MeshShape body(scenes::sphere(8, 5));
    expect_contact(contact_of({body, {}}, {1, 2, 3}, {body, {}}), 0, ClosestKind::intersecting);
    const Contact contact = contact_of({body, {}}, {1, 2, 3}, {body, {}});
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 0, 0}));
}

// The normal of a sliver 2^55 long is off by more than its own length, and so were bounds of the time that took it for
// the true one: they ended before the contact.
TEST(Cast, SliverWhoseNormalIsNotKnown) {
    const MeshShape sliver = shape_of({{0x1.8d3b6d48616b8p+55, -0x1.6eba578a151acp+43, -0x1.928c621b1e158p-15},
                                       {0x1.830f8f32715fcp-36, 0x1.d2e9156e736p-55, 0},
                                       {-0x1.afc2e26434888p+47, 0x1.4f9099c8e6fd4p+35, 0x1.e708b20e47286p+21}}),
                    other = shape_of({{-0x1.c940952531854p-40, -0x1.3f256bd912238p+21, -0x1.92b5fe8e9afd9p-43},
                                      {0x1.7687857ce21f4p+40, 0, 0x1.7c39fe74e2f5p-6},
                                      {-0x1.a5da22b753d48p+28, 0x1.3281ee340c1c4p-55, 0}});
    Pose pose;
    pose.R << -0x1.887132e5a70b4p-1, -0x1.1a8a77a905fc6p-1, 0x1.50797ba3ef50ep-2, 0x1.7e3bf3959fdp-2,
        0x1.13087714d844p-5, 0x1.daae87fca42d6p-1, -0x1.0b987761959eap-1, 0x1.aaa31527290aep-1, 0x1.7128f6d601dc8p-3;
    pose.t = Vec3(0x1.2e8de37f2349dp+53, -0x1.26a8d2aa0af9ep+52, -0x1.f7b9cfad10f59p+58);
    Pose still;
    still.t = Vec3(-0x1.a86b7b0e7786p-61, -0x1.d86a1288d608cp+24, -0x1.fe2cb9fbe111cp+58);
    const Vec3 motion(-0x1.7687857ce3c18p+40, -0x1.3f25688d608cp+21, 0);
    expect_contact(contact_of({sliver, pose}, motion, {other, still}), 0x1.ffffffffd89ebp-2, ClosestKind::vertex_face);
}

}  // namespace
}  // namespace ecods
