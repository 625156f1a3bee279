// The questions of distance.hpp and solid.hpp about points: the oracle's answers, and those about two bodies of which
// one is the point.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/primitives.hpp"
#include "ecods/solid.hpp"
#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "judge/distance_truth.hpp"
#include "oracle/solid.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/shapes.hpp"
#include "scenes/solid_cases.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using scenes::Random;

const MeshShape& one_point() {
    static const MeshShape shape(Mesh::create({Vec3::Zero()}, {Triangle{0, 0, 0}}));
    return shape;
}

// The answer about two bodies, one of which is the point.
ClosestPoint closest_of_bodies(const Vec3& point, const Posed<MeshShape>& body, QueryMemory& memory) {
    Pose at;
    at.t = point;
    const ClosestPoints points = closest({one_point(), at}, body, memory);
    return {points.distance, points.kind == ClosestKind::contained ? no_feature : points.b, points.point_b};
}

oracle::Soup soup_of(const Posed<MeshShape>& body) {
    return {body.what->mesh().vertices(), body.what->mesh().triangles(), body.pose};
}

// What is true of a point and a surface.
ClosestPoint true_closest(const Vec3& point, const Posed<MeshShape>& body) {
    static const std::array<Triangle, 1> triangle{Triangle{0, 0, 0}};
    const std::array<Vec3, 1> vertices{point};
    const oracle::Soup only{vertices, triangle, Pose{}};
    const ClosestPoints points = judge::to_closest_points(oracle::MeshDistances(only, soup_of(body)).closest());
    return {points.distance, points.b, points.point_b};
}

// Corners of the body and points of its edges and faces, as they round, some of them moved by an ulp or more.
Vec3 some_point(Random& random, const Mesh& mesh, const Pose& pose) {
    const Triangle& t = mesh.triangles()[random.below(static_cast<std::uint32_t>(mesh.triangles().size()))];
    const auto corner = [&](std::size_t i) -> const Vec3& { return mesh.vertices()[t[i]]; };
    Vec3 v = corner(0);
    switch (random.below(4)) {
        case 0:
            v = 0.5 * corner(0) + 0.5 * corner(1);
            break;
        case 1:
            v = 0.5 * corner(0) + 0.25 * corner(1) + 0.25 * corner(2);
            break;
        case 2:
            v += 0.3 * (corner(1) - corner(2));
            break;
        default:
            break;
    }
    Vec3 point = pose.R * v + pose.t;
    const int axis = static_cast<int>(random.below(3));
    if (random.below(2) == 0) point[axis] = std::nextafter(point[axis], random.uniform(-1, 1) * 1e300);
    if (random.below(4) == 0) point *= 1 + std::ldexp(1.0, -static_cast<int>(random.below(50)));
    return point.allFinite() ? point : Vec3(1, 2, 3);
}

TEST(Points, EveryFamilyAsTheOracleAndAsTwoBodies) {
    QueryMemory memory;
    Random random(1);
    const auto sets = environment::supported_instruction_sets();
    scenes::for_each_case(scenes::distance_families(), random, 12, [&](const scenes::DistanceCase& c, Random& more) {
        const MeshShape shape(c.b);
        const Posed<MeshShape> body(shape, c.pose_b);
        for (int i = 0; i < 3; ++i) {
            const bool is_own = i == 0;
            const Vec3 point = some_point(more, is_own ? *c.b : *c.a, is_own ? c.pose_b : c.pose_a);
            const ClosestPoint truth = true_closest(point, body);
            const ClosestPoint of_bodies = closest_of_bodies(point, body, memory);
            const environment::InstructionSetLimit limit(sets[more.below(static_cast<std::uint32_t>(sets.size()))]);
            const environment::FloatMode& mode = environment::float_modes[more.below(8)];
            ClosestPoint found;
            double signed_one = 0;
            {
                const environment::InFloatMode in(mode);
                found = closest(point, body, memory);
                signed_one = signed_distance(point, body, memory);
            }
            EXPECT_EQ(found, truth) << mode.name << ": " << judge::text(found.distance) << " is not "
                                    << judge::text(truth.distance);
            EXPECT_EQ(found, of_bodies) << mode.name;
            EXPECT_EQ(std::bit_cast<std::uint64_t>(signed_one), std::bit_cast<std::uint64_t>(truth.distance))
                << mode.name;
        }
    });
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int k = 0; k < 3; ++k) {
        const auto seen = [k](const Vec3& v) { return Vec2(v[(k + 1) % 3], v[(k + 2) % 3]); };
        if (orient2d(seen(a), seen(b), seen(c)) != Sign::zero) return true;
    }
    return false;
}

// The surface that bounds the solid.
Posed<MeshShape> proper_boundary(const Posed<MeshShape>& solid, std::shared_ptr<const MeshShape>& keep) {
    std::vector<Triangle> triangles;
    const auto vertices = solid.what->mesh().vertices();
    for (const Triangle& t : solid.what->mesh().triangles()) {
        if (has_area(vertices[t[0]], vertices[t[1]], vertices[t[2]])) triangles.push_back(t);
    }
    keep = std::make_shared<const MeshShape>(Mesh::create({vertices.begin(), vertices.end()}, triangles));
    return {keep, solid.pose};
}

TEST(Points, SolidsOfEveryFamily) {
    QueryMemory memory;
    Random random(2);
    int inside = 0, outside = 0;
    scenes::for_each_case(scenes::solid_families(), random, 6, [&](const scenes::SolidCase& c, Random& more) {
        const Solid solid(c.a.mesh);
        const Posed<MeshShape> body(solid, c.a.pose);
        std::vector<Vec3> points = c.known_points();
        for (int i = 0; i < 4; ++i) {
            const bool is_own = i % 2 == 0;
            points.push_back(some_point(more, is_own ? *c.a.mesh : *c.b.mesh, is_own ? c.a.pose : c.b.pose));
        }
        for (const Vec3& v : c.a.mesh->vertices().first(std::min<std::size_t>(c.a.mesh->vertices().size(), 4))) {
            points.push_back(c.a.pose.R * (0.75 * v) + c.a.pose.t);
        }
        for (const Vec3& point : points) {
            const Location location = locate(point, {solid, c.a.pose}, memory);
            const oracle::PointSide side = oracle::locate(point, soup_of(body)).side;
            ASSERT_EQ(static_cast<int>(location.side), static_cast<int>(side));
            const double found = signed_distance(point, body, memory);
            const ClosestPoint nearest = closest(point, body, memory);
            ASSERT_EQ(nearest, closest_of_bodies(point, body, memory));
            EXPECT_EQ(found < 0, side == oracle::PointSide::inside);
            EXPECT_EQ(found == 0, side == oracle::PointSide::on);
            if (side == oracle::PointSide::inside) {
                EXPECT_EQ(nearest, (ClosestPoint{0, no_feature, point}));
                std::shared_ptr<const MeshShape> keep;
                EXPECT_EQ(-found, true_closest(point, proper_boundary(body, keep)).distance);
                ++inside;
            } else {
                EXPECT_EQ(found, nearest.distance);
                ++outside;
            }
        }
    });
    EXPECT_GT(inside, 100);
    EXPECT_GT(outside, 100);
}

TEST(Points, FarPointsAndTies) {
    QueryMemory memory;
    Random random(4);
    const Solid ball(scenes::sphere(24, 12)), torus(scenes::torus(16, 8, 0.4));
    for (const Solid* solid : {&ball, &torus}) {
        for (int i = 0; i < 3; ++i) {
            const Pose pose = i == 0 ? Pose{} : random.turned();
            const Posed<MeshShape> body(*solid, pose);
            for (const double far : {0.0, 1e-9, 1.0, 3.0, 600.0, 1e3, 1e6, 1e15, 1e300}) {
                const Vec3 point = pose.t + far * random.direction();
                const ClosestPoint found = closest(point, body, memory);
                EXPECT_EQ(found, closest_of_bodies(point, body, memory)) << far;
                const bool is_inside = locate(point, {*solid, pose}, memory).side == Side::inside;
                const double number = signed_distance(point, body, memory);
                EXPECT_EQ(number < 0, is_inside) << far;
                const ClosestPoint on_surface = true_closest(point, body);
                EXPECT_EQ(std::abs(number), on_surface.distance) << far;
            }
        }
    }
}

TEST(Points, AnyPose) {
    QueryMemory memory;
    Random random(5);
    const Solid solid(octahedron({0.25, 0.5, 0}, 1).mesh());
    for (int i = 0; i < 60; ++i) {
        Pose pose = random.turned();
        if (i % 4 == 0) pose.R.col(1) += 0.75 * pose.R.col(0);
        if (i % 4 == 1) pose.R.row(2) *= std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
        if (i % 4 == 2) pose.R.col(2) = i % 8 == 2 ? Vec3::Zero() : Vec3(2 * pose.R.col(0));  // singular
        const Posed<MeshShape> body(solid, pose);
        for (int k = 0; k < 8; ++k) {
            const Vec3 point = pose.R * (1.5 * random.direction() * random.uniform(0, 1)) + pose.t;
            const double number = signed_distance(point, body, memory);
            EXPECT_EQ(std::abs(number), true_closest(point, body).distance);
            EXPECT_EQ(number < 0, locate(point, {solid, pose}, memory).side == Side::inside);
            EXPECT_EQ(closest(point, body, memory), closest_of_bodies(point, body, memory));
        }
    }
}

// Work is that of one triangle for nearly every point near a fine mesh.
TEST(Points, FewTrianglesAreEnclosed) {
    const MeshShape ball(scenes::sphere(200, 100));
    Random random(7);
    QueryCounts counts;
    for (int i = 0; i < 200; ++i) {
        static_cast<void>(
            signed_distance(Vec3(random.uniform(0.99, 1.01) * random.direction()), {ball, Pose{}}, counts));
    }
    EXPECT_LT(counts.distances.enclosures, 400u);
    EXPECT_LT(counts.distances.exact, 230u);
    EXPECT_LT(counts.distances.triangle_bounds, 200u * 60);
}

}  // namespace
}  // namespace ecods
