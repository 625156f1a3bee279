// Casts of deforming meshes: known answers, queries of vertex and face and of two edges, as the public test sets of
// continuous collision detection have them, and meshes; against the oracle.
#include "ecods/cast.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "environment/each_environment.hpp"
#include "judge/cast_truth.hpp"
#include "judge/text.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using Contact = std::optional<FirstContact>;
using Points = std::vector<Vec3>;

std::shared_ptr<const MeshShape> shape_of(Points vertices, const std::vector<Triangle>& triangles) {
    return std::make_shared<const MeshShape>(Mesh::create(std::move(vertices), triangles));
}
oracle::DeformingSoup soup_of(const Deforming& mesh) {
    const Mesh& start = mesh.shape()->mesh();
    return {{start.vertices(), start.triangles(), Pose()}, {mesh.mesh_at_end().vertices(), start.triangles(), Pose()}};
}
Contact truth(const Deforming& a, const Deforming& b) {
    return judge::to_first_contact(oracle::first_contact(soup_of(a), soup_of(b)));
}

// Asks in both orders, without a witness and with one from elsewhere, and at limits of time beside the answer.
Contact expect_right(const Deforming& a, const Deforming& b, PairWitness& witness) {
    const Contact expected = truth(a, b), back = truth(b, a);
    const auto expect = [](const Contact& got, const Contact& right, const char* what) {
        EXPECT_TRUE(judge::is_same(got, right)) << what << ": " << judge::text(got) << ", not " << judge::text(right);
    };
    expect(cast(a, b), expected, "cast");
    expect(cast(b, a), back, "swapped");
    expect(cast(a, b, 1, witness), expected, "with a witness");
    expect(cast(a, b, 1, witness), expected, "with its own witness");
    if (expected) {
        expect(cast(a, b, std::nextafter(expected->time, 2)), expected, "after it");
        if (expected->time > 0) expect(cast(a, b, std::nextafter(expected->time, 0)), std::nullopt, "before it");
    }
    return expected;
}
Contact expect_right(const Deforming& a, const Deforming& b) {
    PairWitness witness;
    return expect_right(a, b, witness);
}

Deforming vertex(const Vec3& from, const Vec3& to) {
    return {shape_of({from}, {{0, 0, 0}}), {to}};
}
Deforming edge(const std::array<Vec3, 2>& from, const std::array<Vec3, 2>& to) {
    return {shape_of({from[0], from[1]}, {{0, 1, 1}}), {to[0], to[1]}};
}
Deforming face(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
    return {shape_of({from[0], from[1], from[2]}, {{0, 1, 2}}), {to[0], to[1], to[2]}};
}

TEST(Deforming, VertexAndFace) {
    const std::array<Vec3, 3> flat{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)};
    const Deforming rests = face(flat, flat);
    const Contact falls = expect_right(vertex({0, 0, 1}, {0, 0, -2}), rests);
    EXPECT_EQ(falls->time, 1 / 3.0);
    EXPECT_EQ(falls->kind, ClosestKind::vertex_face);
    EXPECT_FALSE(expect_right(vertex({0, 0, 1}, {0, 0, 0x1p-60}), rests));
    EXPECT_EQ(expect_right(vertex({0, 0, 1}, {0, 0, 0}), rests)->time, 1);
    EXPECT_EQ(expect_right(vertex({0, 0, 0}, {0, 0, 1}), rests)->kind, ClosestKind::intersecting);
    EXPECT_EQ(expect_right(vertex({0.5, 0.5, 1}, {0.5, 0.5, -1}), rests)->kind, ClosestKind::vertex_edge);
    EXPECT_EQ(expect_right(vertex({2, -1, 1}, {2, -1, -1}), rests)->kind, ClosestKind::vertex_vertex);
    // In the plane of the face all the time: it comes over an edge.
    const Contact coplanar = expect_right(vertex({-3, 0, 0}, {1, 0, 0}), rests);
    EXPECT_EQ(coplanar->time, 0.5);
    EXPECT_EQ(coplanar->kind, ClosestKind::vertex_edge);
    // The face grows from a point, and becomes a point.
    const std::array<Vec3, 3> point{Vec3(9, 0, 0), Vec3(9, 0, 0), Vec3(9, 0, 0)};
    EXPECT_EQ(expect_right(vertex({4.5, 0, 1}, {4.5, 0, -1}), face(point, flat))->time, 0.5);
    const Contact shrinks = expect_right(vertex({9, 0, 0}, {9, 0, 0}), face(flat, point));
    EXPECT_EQ(shrinks->time, 1);
    // The face turns inside out while the vertex waits: it becomes a segment half-way.
    EXPECT_EQ(expect_right(vertex({0.25, 0, 0}, {0.25, 0, 0}), face({Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 0, 2)},
                                                                    {Vec3(1, -1, -1), Vec3(1, 1, -1), Vec3(1, 0, 2)}))
                  ->time,
              0.25);
}

TEST(Deforming, TwoEdges) {
    const Deforming along_y = edge({Vec3(0, -1, 0), Vec3(0, 1, 0)}, {Vec3(0, -1, 0), Vec3(0, 1, 0)});
    const Contact crossed =
        expect_right(edge({Vec3(-1, 0, 1), Vec3(1, 0, 1)}, {Vec3(-1, 0, -2), Vec3(1, 0, -2)}), along_y);
    EXPECT_EQ(crossed->time, 1 / 3.0);
    EXPECT_EQ(crossed->kind, ClosestKind::edge_edge);
    // An edge that turns over the other one, one end up, one end down: parallel to it half-way, and just beside it.
    EXPECT_FALSE(
        expect_right(edge({Vec3(1, -1, 0), Vec3(1, 1, 0)}, {Vec3(0x1p-60, 1, 0), Vec3(0x1p-60, -1, 0)}), along_y));
    EXPECT_TRUE(expect_right(edge({Vec3(1, -1, 0), Vec3(1, 1, 0)}, {Vec3(0, 1, 0), Vec3(0, -1, 0)}), along_y));
    // On one line all the time.
    const Contact on_line = expect_right(edge({Vec3(0, 4, 0), Vec3(0, 5, 0)}, {Vec3(0, 0, 0), Vec3(0, 9, 0)}), along_y);
    EXPECT_EQ(on_line->time, 0.75);
    EXPECT_EQ(on_line->kind, ClosestKind::vertex_vertex);
    // They graze: the heights are 1 - 4 s + 4 s^2 apart, a square.
    const Contact grazes = expect_right(
        vertex({0, 0, 1}, {1, 0, -3}),
        face({Vec3(-8, -8, 0), Vec3(8, -8, 0), Vec3(0, 8, 0)}, {Vec3(-8, -8, 32), Vec3(8, -8, -32), Vec3(0, 8, 0)}));
    EXPECT_EQ(grazes->time, 0.5);
}

// Points of a query at both ends: on a lattice, so that they are often in one plane, on one line or equal, or anywhere.
class Queries : public testing::TestWithParam<int> {};

TEST_P(Queries, AsTheOracle) {
    scenes::Random random(81 + static_cast<std::uint32_t>(GetParam()));
    const double unit = GetParam() == 3 ? 0x1p-300 : 1;
    const auto point = [&] {
        const std::uint32_t size = GetParam() == 0 ? 3 : 9;
        if (GetParam() == 2) return Vec3(random.direction() * random.uniform(0, 2));
        return Vec3(unit * Vec3(random.below(size), random.below(size), random.below(size)));
    };
    const auto moved = [&](const Vec3& p) { return random.below(4) == 0 ? p : point(); };
    std::map<std::string, int> kinds;
    PairWitness witness;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        const std::array<Vec3, 4> p{point(), point(), point(), point()};
        const std::array<Vec3, 4> q{moved(p[0]), moved(p[1]), moved(p[2]), moved(p[3])};
        const bool are_edges = i % 2 == 0;
        const Deforming a = are_edges ? edge({p[0], p[1]}, {q[0], q[1]}) : vertex(p[0], q[0]);
        const Deforming b = are_edges ? edge({p[2], p[3]}, {q[2], q[3]}) : face({p[1], p[2], p[3]}, {q[1], q[2], q[3]});
        const Contact found = expect_right(a, b, witness);
        ++kinds[found ? judge::text(found->kind) : "none"];
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(kinds["none"], 40);
    EXPECT_GT(kinds["edge-edge"] + kinds["vertex-face"], 15);
    const bool is_on_small_lattice = GetParam() == 0;
    EXPECT_TRUE(!is_on_small_lattice || kinds["vertex-edge"] + kinds["vertex-vertex"] > 15);
}

INSTANTIATE_TEST_SUITE_P(Deforming, Queries, testing::Values(0, 1, 2, 3));

Points deformed(const Mesh& mesh, const Vec3& motion, double most, scenes::Random& random) {
    Points points;
    for (const Vec3& v : mesh.vertices()) points.push_back(v + motion + random.uniform(0, most) * random.direction());
    return points;
}

// Trees of several levels.
TEST(Deforming, MeshesAsTheOracle) {
    scenes::Random random(85);
    PairWitness witness;
    int found_count = 0;
    for (int i = 0; i < 24; ++i) {
        SCOPED_TRACE(i);
        const Vec3 far = 3 * random.direction();
        const auto ball = std::make_shared<const MeshShape>(
            scenes::mapped(*scenes::sphere(10, 6), [&](const Vec3& v) { return Vec3(v + far); }));
        const auto ring = std::make_shared<const MeshShape>(scenes::torus(10, 6, 0.4));
        const double most = i % 3 == 0 ? 0.01 : i % 3 == 1 ? 0.3 : 2;
        const Deforming a(ball, deformed(ball->mesh(), -1.25 * far + random.direction(), most, random));
        const Deforming b(ring, deformed(ring->mesh(), Vec3::Zero(), i % 2 == 0 ? 0 : most, random));
        found_count += expect_right(a, b, witness).has_value();
        // The same ring at rest, as a posed body and as one that moves.
        if (i % 2 == 0) {
            const Posed<MeshShape> rests(ring, Pose());
            const Deforming same(ring, {ring->mesh().vertices().begin(), ring->mesh().vertices().end()});
            EXPECT_EQ(cast(a, rests), cast(a, same));
            EXPECT_EQ(cast(rests, a), cast(same, a));
            EXPECT_EQ(cast(a, Moving<MeshShape>(ring, Pose(), at(0.5))),
                      cast(a, Deforming(ring, deformed(ring->mesh(), Vec3(0.5, 0, 0), 0, random))));
            EXPECT_EQ(cast(Moving<MeshShape>(ring, Pose(), at(0.5)), a),
                      cast(Deforming(ring, deformed(ring->mesh(), Vec3(0.5, 0, 0), 0, random)), a));
        }
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(found_count, 12);
}

// A mesh that is moved and sheared by a pose of small integers is a body that moves.
TEST(Deforming, RigidIsMoving) {
    scenes::Random random(86);
    const auto ring = std::make_shared<const MeshShape>(scenes::torus(24, 12, 0.4));
    const auto ball = std::make_shared<const MeshShape>(scenes::sphere(16, 9));
    for (int i = 0; i < 10; ++i) {
        Pose to;
        for (int k = 0; k < 9; ++k) to.R.data()[k] = static_cast<double>(random.below(5)) - 2;
        to.t = Vec3(random.below(5), random.below(5), random.below(5)) - Vec3(2, 2, 2);
        Points points;
        for (const Vec3& v : ball->mesh().vertices()) points.push_back(to.R * v + to.t);
        const Pose there = at(3.5, 0.25, 0);
        QueryCounts of_moving, of_deforming;
        EXPECT_EQ(cast(Deforming(ball, points), Posed<MeshShape>(ring, there), 1, of_deforming),
                  cast(Moving<MeshShape>(ball, Pose(), to), Moving<MeshShape>(ring, there, there), 1, of_moving));
        EXPECT_EQ(of_deforming.queries, of_moving.queries);
    }
}

TEST(Deforming, BesideSolids) {
    const auto room = std::make_shared<const ConvexSolid>(scenes::cube(4)),
               cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    const auto walls = surface_of(*room), sheet = surface_of(*cube);
    const Points same(sheet->mesh().vertices().begin(), sheet->mesh().vertices().end());
    Points moved = same;
    for (Vec3& v : moved) v[0] += 7;
    const Contact contained = cast(Deforming(sheet, moved), Posed<MeshShape>(room, Pose()));
    EXPECT_EQ(contained->time, 0);
    EXPECT_EQ(contained->kind, ClosestKind::contained);
    EXPECT_EQ(cast(Posed<MeshShape>(room, Pose()), Deforming(sheet, moved))->kind, ClosestKind::contained);
    EXPECT_EQ(cast(Deforming(sheet, moved), Posed<MeshShape>(walls, Pose()))->time, 0.5);
    // A solid that deforms counts as its surface, so nothing is inside of it.
    const Points of_room(room->mesh().vertices().begin(), room->mesh().vertices().end());
    EXPECT_FALSE(cast(Deforming(room, of_room), Posed<MeshShape>(cube, Pose())));
    EXPECT_EQ(cast(Deforming(room, of_room), Moving<MeshShape>(cube, Pose(), at(7)))->time, 0.5);
    EXPECT_EQ(cast(Deforming(cube, moved), Posed<MeshShape>(room, Pose()))->kind, ClosestKind::contained);
    EXPECT_EQ(Deforming(room, of_room).shape(), room);
}

TEST(Deforming, Errors) {
    const auto cube = std::make_shared<const MeshShape>(scenes::cube(0.5));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Deforming(nullptr, Points(8, Vec3::Zero())), InvalidArgument);
    EXPECT_THROW(Deforming(cube, Points(7, Vec3::Zero())), InvalidMesh);
    EXPECT_THROW(Deforming(cube, Points(8, Vec3(0, nan, 0))), InvalidMesh);
    const Deforming mesh(cube, Points(9, Vec3(0, 0, 0)));
    EXPECT_EQ(mesh.mesh_at_end().vertices().size(), 9U);
    EXPECT_THROW((void)cast(mesh, Posed<MeshShape>(cube, at(5)), nan), InvalidArgument);
    EXPECT_THROW((void)cast(mesh, mesh, -1), InvalidArgument);
    EXPECT_EQ(cast(mesh, mesh, 7)->time, 0);
}

// Very large and very small, and one that grows from one to the other.
TEST(Deforming, AnyScale) {
    const std::array<Vec3, 3> flat{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)};
    for (const double unit : {0x1p-1070, 0x1p-500, 0x1p-210, 0x1p210, 0x1p600, 0x1p950, 0x1p1020}) {
        const std::array<Vec3, 3> scaled{unit * flat[0], unit * flat[1], unit * flat[2]};
        EXPECT_EQ(expect_right(vertex({0, 0, unit}, {0, 0, -2 * unit}), face(scaled, scaled))->time, 1 / 3.0) << unit;
        EXPECT_EQ(expect_right(vertex({0, 0, 1}, {0, 0, -2}), face(flat, scaled))->time, 1 / 3.0) << unit;
    }
}

TEST(Deforming, TheSameInEveryEnvironment) {
    scenes::Random random(87);
    std::vector<std::pair<Deforming, Deforming>> asked;
    for (int i = 0; i < 6; ++i) {
        const auto ball = std::make_shared<const MeshShape>(
            scenes::mapped(*scenes::sphere(7, 4), [&](const Vec3& v) { return Vec3(v + Vec3(3, 0.25, 0)); }));
        const auto ring = std::make_shared<const MeshShape>(scenes::torus(7, 4, 0.4));
        asked.emplace_back(Deforming(ball, deformed(ball->mesh(), {-3, 0.125, 0}, 0.25, random)),
                           Deforming(ring, deformed(ring->mesh(), {0, 0, 0}, 0.25, random)));
    }
    const auto ask = [&] {
        std::vector<Contact> all;
        for (const auto& [a, b] : asked) {
            all.push_back(cast(a, b));
            all.push_back(
                cast(b, Deforming(a.shape(), {a.mesh_at_end().vertices().begin(), a.mesh_at_end().vertices().end()})));
        }
        return all;
    };
    const auto expected = ask();
    EXPECT_TRUE(expected[0] && expected[0]->time > 0);
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
}

}  // namespace
}  // namespace ecods
