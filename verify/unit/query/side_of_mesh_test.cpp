// Points and solids beside CGAL's Side_of_triangle_mesh, whose vertices are posed in exact arithmetic.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ecods/solid.hpp"
#include "oracle/exact_point.hpp"
#include "scenes/shapes.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

// CGAL wants manifolds of one orientation: where more than two triangles meet, vertices are doubled.
SurfaceMesh surface_mesh(const Mesh& mesh, const Pose& pose) {
    std::vector<Point> points;
    for (const Vec3& v : mesh.vertices()) points.push_back(oracle::posed_point<Kernel>(pose, v));
    std::vector<std::array<std::size_t, 3>> faces;
    for (const Triangle& t : mesh.triangles()) faces.push_back({t[0], t[1], t[2]});
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
    SurfaceMesh result;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, result);
    return result;
}

struct Counts {
    std::array<int, 3> sides{};
};

// Corners, points of edges and faces, as doubles have them, and their neighbours; and points anywhere near.
Vec3 random_point(const Mesh& mesh, const Pose& pose, scenes::Random& random) {
    const auto triangles = mesh.triangles();
    const Triangle& t = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
    const auto corner = [&](std::size_t i) { return mesh.vertices()[t[i]]; };
    const std::uint32_t choice = random.below(5);
    Vec3 v = corner(0);
    if (choice == 1) v = 0.5 * v + 0.5 * corner(1);
    if (choice == 2) v = 0.5 * v + 0.25 * corner(1) + 0.25 * corner(2);
    Vec3 point = pose.R * v + pose.t;
    if (choice == 3) point += random.direction() * random.uniform(0, 1) * (pose.R * (corner(1) - corner(0))).norm();
    if (choice == 4) {
        const Vec3 other = pose.R * mesh.vertices()[triangles[0][0]] + pose.t;
        point = point + random.uniform(0, 1) * (other - point);
    }
    if (random.below(3) == 0) {
        const auto axis = static_cast<int>(random.below(3));
        const double limit = std::numeric_limits<double>::max();
        point[axis] = std::nextafter(point[axis], random.below(2) == 0 ? limit : -limit);
    }
    return point;
}

void expect_same(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, int count, scenes::Random& random,
                 Counts& counts) {
    const Solid solid(mesh);
    const SurfaceMesh surface = surface_mesh(*mesh, pose);
    ASSERT_TRUE(CGAL::is_closed(surface));
    const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side_of(surface);
    QueryMemory memory;
    for (int i = 0; i < count; ++i) {
        const Vec3 point = random_point(*mesh, pose, random);
        const CGAL::Bounded_side side = side_of(Point(point[0], point[1], point[2]));
        const Side expected = side == CGAL::ON_BOUNDARY       ? Side::on
                              : side == CGAL::ON_BOUNDED_SIDE ? Side::inside
                                                              : Side::outside;
        ++counts.sides[static_cast<std::size_t>(expected)];
        ASSERT_EQ(locate(point, {solid, pose}, memory).side, expected) << point.transpose();
    }
}

TEST(SideOfMesh, RoundBodiesAsCgal) {
    scenes::Random random(1);
    Counts counts;
    for (const auto& mesh : {scenes::cube(0.5), scenes::sphere(24, 12), scenes::torus(24, 12, 0.4)}) {
        for (int i = 0; i < 6; ++i) {
            Pose pose;
            if (i > 0) pose.R = random.rotation().toRotationMatrix();
            if (i > 1) pose.t = random.direction();
            if (i == 3) pose.R.col(1) *= -1;
            if (i == 4) pose.R *= 0x1p-300;
            if (i == 5) pose.R(0, 1) += 3;
            ASSERT_NO_FATAL_FAILURE(expect_same(mesh, pose, 150, random, counts));
        }
    }
    for (const int count : counts.sides) EXPECT_GT(count, 50);
}

// Points of lattices are on faces, edges and corners exactly.
TEST(SideOfMesh, PolycubesAsCgal) {
    scenes::Random random(2);
    Counts counts;
    const std::vector<scenes::Cells> all = scenes::polycubes(4);
    for (int i = 0; i < 30; ++i) {
        const scenes::Cells& cells = all[random.below(static_cast<std::uint32_t>(all.size()))];
        const scenes::PosedMesh body =
            scenes::place(scenes::boundary(cells, false, random), scenes::random_map(random), 0, random);
        // A polygon soup has its equal corners as one.
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (Triangle t : body.mesh->triangles()) {
            for (std::uint32_t& index : t) {
                const Vec3 v = body.mesh->vertices()[index];
                const auto at = std::ranges::find_if(vertices, [&](const Vec3& w) { return w == v; });
                index = static_cast<std::uint32_t>(at - vertices.begin());
                if (at == vertices.end()) vertices.push_back(v);
            }
            triangles.push_back(t);
        }
        const auto mesh = Mesh::create(std::move(vertices), std::move(triangles));
        ASSERT_NO_FATAL_FAILURE(expect_same(mesh, body.pose, 60, random, counts));
    }
    for (const int count : counts.sides) EXPECT_GT(count, 100);
}

TEST(SideOfMesh, NestedShellsAsCgal) {
    scenes::Random random(3);
    Counts counts;
    const auto unit = scenes::sphere(12, 8);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const double size : {1.0, 0.75, 0.5, 0.25}) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3& v : unit->vertices()) vertices.push_back(size * v);
        for (const Triangle& t : unit->triangles()) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const auto mesh = Mesh::create(std::move(vertices), std::move(triangles));
    for (int i = 0; i < 4; ++i) {
        Pose pose = random.turned();
        ASSERT_NO_FATAL_FAILURE(expect_same(mesh, pose, 200, random, counts));
    }
    EXPECT_GT(counts.sides[0], 50);
    EXPECT_GT(counts.sides[2], 50);
}

}  // namespace
}  // namespace ecods
