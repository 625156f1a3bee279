// The signed distance of two convex solids with its points, and of any two bodies in an interval.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

ConvexSolid solid_box(const Vec3& half) {
    return ConvexSolid(soup_of_box(-half, half).mesh());
}

// Of `sides` vertices on a circle of radius 1, the first at an angle, from z = -1 to 1.
ConvexSolid prism(int sides, double first) {
    std::vector<Vec3> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = first + 2 * M_PI * i / sides;
        for (const double z : {-1.0, 1.0}) points.push_back({std::cos(angle), std::sin(angle), z});
    }
    return ConvexSolid(std::span<const Vec3>(points));
}

TEST(SignedDistance, OfBoxesOnTheLattice) {
    const ConvexSolid a = solid_box({1, 2, 3}), b = solid_box({0.5, 0.5, 0.5});
    struct Case {
        Vec3 t;
        double distance;
        Vec3 direction;
        ClosestKind kind;
    };
    const auto vertex_face = ClosestKind::vertex_face, vertex_edge = ClosestKind::vertex_edge;
    for (const Case& c :
         {Case{{1, 0, 0}, -0.5, {1, 0, 0}, vertex_face}, Case{{1.5, 0, 0}, 0, {1, 0, 0}, vertex_face},
          Case{{2, 0, 0}, 0.5, {1, 0, 0}, vertex_face}, Case{{-1.25, 1.5, 0}, -0.25, {-1, 0, 0}, vertex_edge},
          Case{{0.5, -2, 2.5}, -0.5, {0, -1, 0}, ClosestKind::vertex_vertex},
          Case{{0.5, 2, 2.75}, -0.5, {0, 1, 0}, vertex_edge},
          Case{{0.75, 2, -2.75}, -0.5, {0, 1, 0}, ClosestKind::vertex_face}}) {
        SCOPED_TRACE(c.t.transpose());
        const SignedDistance found = signed_distance({a, Pose()}, {b, at(c.t)});
        EXPECT_EQ(found.distance, c.distance);
        EXPECT_EQ(std::signbit(found.distance), c.distance < 0);
        EXPECT_EQ(found.direction, c.direction);
        EXPECT_EQ(found.kind, c.kind);
        EXPECT_EQ(found.point_b - found.point_a, c.distance * c.direction);
        const SignedDistance back = signed_distance({b, at(c.t)}, {a, Pose()});
        EXPECT_EQ(back.distance, c.distance);
        EXPECT_EQ(back.direction, -c.direction);
        EXPECT_EQ(back.kind, c.kind);
        EXPECT_EQ(back.point_b - back.point_a, c.distance * back.direction);
        const DistanceBounds bounds = signed_distance_bounds({a, Pose()}, {b, at(c.t)});
        EXPECT_EQ(bounds.lower, c.distance);
        EXPECT_EQ(bounds.upper, c.distance);
    }
}

// trimesh, tests/test_collision.py: two cubes at one place, of which a face and a vertex are first by name.
TEST(SignedDistance, OfCubesAtOnePlace) {
    const Vec3 h(0.5, 0.5, 0.5);
    Soup soup = soup_of_box(-h, h);
    std::swap(soup.triangles[0], soup.triangles[1]);
    std::rotate(soup.triangles[0].begin(), soup.triangles[0].begin() + 2, soup.triangles[0].end());
    const ConvexSolid cube(soup.mesh());
    const SignedDistance found = signed_distance({cube, at(5)}, {cube, at(5)});
    EXPECT_EQ(found.distance, -1);
    EXPECT_EQ(found.direction, Vec3(-1, 0, 0));
    EXPECT_EQ(found.kind, ClosestKind::vertex_vertex);
    EXPECT_EQ(found.a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(found.point_a, Vec3(4.5, -0.5, 0.5));
    EXPECT_EQ(found.point_b, Vec3(5.5, -0.5, 0.5));
}

// The inner polytope's faces are no features: two edges that cross in each other.
TEST(SignedDistance, OfCrossedEdges) {
    const ConvexSolid x(std::vector<Vec3>{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}});
    const ConvexSolid y(std::vector<Vec3>{{0, -1, 0}, {0, 1, 0}, {-1, 0, 1}, {1, 0, 1}});
    for (const double z : {-0.125, 0.0, 0.125}) {
        const SignedDistance found = signed_distance({x, Pose()}, {y, at(0.25, 0.125, z)});
        EXPECT_EQ(found.distance, z);
        EXPECT_EQ(found.kind, ClosestKind::edge_edge);
        EXPECT_EQ(found.point_a, Vec3(0.25, 0, 0));
        EXPECT_EQ(found.point_b, Vec3(0.25, 0, z));
        EXPECT_EQ(found.direction, Vec3(0, 0, 1));
    }
}

// Two beams across each other: only long edges cross, though the line of an end of the first beam crosses the second.
TEST(SignedDistance, OfBeamsAcrossEachOther) {
    const ConvexSolid a = solid_box({5, 0.5, 0.5}), b = solid_box({12, 0.5, 0.5});
    Pose across = at(0, 0, 0.75);
    across.R << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
    const SignedDistance found = signed_distance({a, Pose()}, {b, across}),
                         back = signed_distance({b, across}, {a, Pose()});
    EXPECT_EQ(found.distance, -0.25);
    EXPECT_EQ(found.direction, Vec3(0, 0, 1));
    for (const auto& [kind, on_a, on_b] :
         {std::tuple(found.kind, found.point_a, found.point_b), std::tuple(back.kind, back.point_b, back.point_a)}) {
        EXPECT_EQ(kind, ClosestKind::edge_edge);
        EXPECT_LT(std::abs(on_a[0]), 2);
        EXPECT_EQ(std::abs(on_a[1]), 0.5);
        EXPECT_EQ(on_a[2], 0.5);
        EXPECT_EQ(on_b, Vec3(on_a[0], on_a[1], 0.25));
    }
}

Vec3 normal_of(const Depth& depth, const Mesh& a, const Mesh& b) {
    const auto corner = [](const Mesh& mesh, const Feature& f, std::uint32_t i) -> Vec3 {
        return mesh.vertices()[mesh.triangles()[f.triangle][(f.corner + i) % 3]];
    };
    const auto edge = [&](const Mesh& mesh, const Feature& f, std::uint32_t i) -> Vec3 {
        return corner(mesh, f, i) - corner(mesh, f, 0);
    };
    const Vec3 n = depth.a.kind == Feature::Kind::face   ? edge(a, depth.a, 1).cross(edge(a, depth.a, 2))
                   : depth.b.kind == Feature::Kind::face ? edge(b, depth.b, 1).cross(edge(b, depth.b, 2))
                                                         : edge(a, depth.a, 1).cross(edge(b, depth.b, 1));
    return n.dot(depth.direction) < 0 ? Vec3(-n) : n;
}

// Lattice hulls, made larger by the square of the normal n, so that the shortest translation is a multiple of n in
// doubles. That far they touch; a bit less far they overlap; further by n they are apart, and closest at the same
// features.
TEST(SignedDistance, PartsByTheDifferenceOfThePoints) {
    scenes::Random random(7);
    std::map<ClosestKind, int> kinds;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        const auto hull = [&] { return scenes::to_mesh(scenes::random_lattice_hull(2, 6, random), 1); };
        const ConvexSolid a(hull()), b(hull());
        Pose place;
        for (double& x : place.t) x = static_cast<double>(random.below(5)) - 2;
        const std::optional<Depth> first = depth({a, Pose()}, {b, place});
        if (!first) continue;
        const Vec3 n = normal_of(*first, a.mesh(), b.mesh());
        Pose at_a, at_b;
        at_a.R *= n.squaredNorm();
        at_b = {at_a.R, n.squaredNorm() * place.t};
        const SignedDistance found = signed_distance({a, at_a}, {b, at_b});
        ++kinds[found.kind];
        const auto moved = [&](const Vec3& s) { return signed_distance({a, at_a}, {b, {at_b.R, at_b.t + s}}); };
        const double steps = std::round((found.point_a - found.point_b).dot(n) / n.squaredNorm());
        const SignedDistance touching = moved(steps * n);
        EXPECT_EQ(touching.distance, 0);
        EXPECT_EQ(touching.point_a, touching.point_b);
        EXPECT_EQ(found.distance == 0, steps == 0);
        if (steps > 0) {
            EXPECT_LT(moved(steps * (1 - 0x1p-20) * n).distance, 0);
        }
        const SignedDistance apart = moved((steps + 1) * n);
        EXPECT_EQ(apart.distance, std::sqrt(n.squaredNorm()));
        EXPECT_EQ(apart.kind, found.kind);
        EXPECT_EQ(apart.a, found.a);
        EXPECT_EQ(apart.b, found.b);
        EXPECT_EQ(apart.point_a, found.point_a);
        EXPECT_EQ(apart.direction, found.direction);
    }
    for (const ClosestKind kind :
         {ClosestKind::vertex_vertex, ClosestKind::vertex_edge, ClosestKind::vertex_face, ClosestKind::edge_edge}) {
        EXPECT_GE(kinds[kind], 10) << kind;
    }
}

// A depth below half of the least double.
TEST(SignedDistance, IsNotZeroOfSolidsThatOverlap) {
    const double u = 0x1p-1074;
    const ConvexSolid a(octahedron(Vec3::Zero(), 3 * u).mesh());
    Pose quarter, beside;
    quarter.R *= 0.25;
    beside = {quarter.R, Vec3(u, 0, 0)};
    const SignedDistance found = signed_distance({a, quarter}, {a, beside});
    EXPECT_EQ(found.distance, -u);
    EXPECT_EQ(depth({a, quarter}, {a, beside})->depth, u);
    const DistanceBounds bounds = signed_distance_bounds({a, quarter}, {a, beside});
    EXPECT_EQ(bounds.lower, -u);
    EXPECT_EQ(bounds.upper, -u);
}

// Faces of 300 corners upon each other: of the same corners, and turned by half of a side, so that only edges
// cross.
TEST(SignedDistance, OfPrismsOfManySides) {
    const ConvexSolid a = prism(300, 0), turned = prism(300, M_PI / 300);
    for (const double z : {-1.5, 1.5, 2.0}) {
        SCOPED_TRACE(z);
        const SignedDistance same = signed_distance({a, Pose()}, {a, at(0, 0, z)});
        EXPECT_EQ(same.distance, std::abs(z) - 2);
        EXPECT_EQ(same.kind, ClosestKind::vertex_vertex);
        EXPECT_EQ(same.direction, Vec3(0, 0, z < 0 ? -1 : 1));
        const SignedDistance crossed = signed_distance({a, Pose()}, {turned, at(0, 0, z)});
        EXPECT_EQ(crossed.distance, std::abs(z) - 2);
        EXPECT_EQ(crossed.kind, ClosestKind::edge_edge);
    }
}

TEST(SignedDistance, IsRefusedAtSingularPoses) {
    const ConvexSolid a = solid_box({1, 1, 1});
    Pose flat;
    flat.R(2, 2) = 0;
    for (const int argument : {0, 1}) {
        const Pose &p = argument == 0 ? flat : Pose(), &q = argument == 0 ? Pose() : flat;
        try {
            std::ignore = signed_distance({a, p}, {a, q});
            FAIL();
        } catch (const SingularPose& e) {
            EXPECT_EQ(e.argument, argument);
        }
        EXPECT_EQ(signed_distance_bounds({a, p}, {a, q}).lower, 0);
        EXPECT_EQ(signed_distance_bounds({a, p}, {a, q}).upper, 0);
    }
}

void expect_bounds(const DistanceBounds& bounds, double lower, double upper) {
    EXPECT_EQ(bounds.lower, lower);
    EXPECT_EQ(bounds.upper, upper);
}

TEST(SignedDistanceBounds, OfBodiesOfAnyKind) {
    const Vec3 h(1, 1, 1);
    const MeshPtr large = soup_of_box(-4 * h, 4 * h).mesh(), small = soup_of_box(-h, h).mesh();
    const MeshShape large_surface(large), small_surface(small);
    const Solid large_solid(large), small_solid(small);
    const ConvexSolid small_convex(small);
    for (const MeshShape* a :
         {static_cast<const MeshShape*>(&large_surface), static_cast<const MeshShape*>(&large_solid)}) {
        for (const MeshShape* b :
             {static_cast<const MeshShape*>(&small_surface), static_cast<const MeshShape*>(&small_solid),
              static_cast<const MeshShape*>(&small_convex)}) {
            expect_bounds(signed_distance_bounds({*a, Pose()}, {*b, at(7)}), 2, 2);
            expect_bounds(signed_distance_bounds({*a, Pose()}, {*b, at(5)}), 0, 0);
            expect_bounds(signed_distance_bounds({*b, at(5)}, {*a, Pose()}), 0, 0);
            const bool are_solids = a == &large_solid && b != &small_surface;
            for (const double x : {0.0, 4.0}) {
                const DistanceBounds inside = signed_distance_bounds({*a, Pose()}, {*b, at(x)});
                if (are_solids) {
                    EXPECT_LT(inside.lower, 0);
                    EXPECT_LE(inside.lower, x - 5);
                    EXPECT_GE(inside.upper, x - 5);
                    EXPECT_LE(inside.upper, 0);
                    const DepthBounds depth = *depth_bounds({large_solid, Pose()}, {small_solid, at(x)});
                    if (b == &small_solid) expect_bounds(inside, -depth.upper, -depth.lower);
                } else {
                    const double apart = a == &large_surface && x == 0 ? 3 : 0;
                    expect_bounds(inside, apart, apart);
                }
            }
        }
    }
}

}  // namespace
}  // namespace ecods
