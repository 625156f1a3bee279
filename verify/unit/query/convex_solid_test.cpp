#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/primitives.hpp"
#include "query/convex/convex_parts.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using convex::Hull;
using scenes::Random;
using Rational = mpq_class;

std::vector<Vec3> on_ellipsoid(scenes::Random& random, int count, const Vec3& axes = {1, 1, 1}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(random.direction().cwiseProduct(axes));
    return points;
}

Vec3 point_of(const ConvexSolid& solid, std::uint32_t vertex) {
    return solid.mesh().vertices()[ConvexSolidAccess::hull(solid).mesh_vertices[vertex]];
}

// What a hull promises, from the points alone.
void expect_valid(const ConvexSolid& solid) {
    const Hull& hull = ConvexSolidAccess::hull(solid);
    const auto triangles = solid.mesh().triangles();
    const auto vertices = solid.mesh().vertices();
    ASSERT_EQ(hull.vertex_count() + hull.faces.size(), hull.edges.size() + 2);
    const auto name_less = [](const Feature& x, const Feature& y) {
        return std::pair(x.triangle, x.corner) < std::pair(y.triangle, y.corner);
    };
    EXPECT_TRUE(std::ranges::is_sorted(hull.vertex_names, name_less));
    EXPECT_TRUE(std::ranges::is_sorted(hull.edges, name_less, &Hull::Edge::name));
    EXPECT_TRUE(std::ranges::is_sorted(hull.faces, name_less, &Hull::Face::name));
    for (std::uint32_t v = 0; v < hull.vertex_count(); ++v) {
        const Feature& name = hull.vertex_names[v];
        EXPECT_EQ(vertices[triangles[name.triangle][name.corner]], point_of(solid, v));
        std::set<std::uint32_t> ends;
        for (const Hull::Neighbor& n : hull.neighbors_of(v)) {
            ends.insert(n.vertex);
            const auto& edge = hull.edges[n.edge];
            EXPECT_EQ(edge.ends[0] == v ? edge.ends[1] : edge.ends[0], n.vertex);
        }
        EXPECT_EQ(ends.size(), hull.neighbors_of(v).size());
        EXPECT_GE(ends.size(), 3u);
    }
    for (const Hull::Edge& edge : hull.edges) EXPECT_LT(edge.ends[0], edge.ends[1]);
    for (std::uint32_t f = 0; f < hull.faces.size(); ++f) {
        const auto cycle = hull.cycle_of(f);
        ASSERT_GE(cycle.size(), 3u);
        for (std::size_t k = 0; k < cycle.size(); ++k) {
            const std::uint32_t from = cycle[k].vertex, to = cycle[(k + 1) % cycle.size()].vertex;
            EXPECT_LE(cycle[0].vertex, from);
            const auto& edge = hull.edges[cycle[k].edge];
            EXPECT_EQ(edge.ends[0], std::min(from, to));
            EXPECT_EQ(edge.faces[from < to ? 0 : 1], f);
        }
        // Every vertex is below the face's plane or in it, and those in it are the face's.
        const Vec3 a = point_of(solid, cycle[0].vertex), b = point_of(solid, cycle[1].vertex);
        const Vec3 c = point_of(solid, cycle[2].vertex);
        std::size_t in_plane = 0;
        for (std::uint32_t v = 0; v < hull.vertex_count(); ++v) {
            const Sign side = orient3d(a, b, c, point_of(solid, v));
            ASSERT_NE(side, Sign::positive);
            in_plane += side == Sign::zero;
        }
        EXPECT_EQ(in_plane, cycle.size());
    }
}

TEST(ConvexSolid, BoxesHoweverTheirFacesAreCut) {
    for (const int parts : {1, 2, 5}) {
        const ConvexSolid solid(box({0, 0, 0}, {1, 2, 3}, parts));
        const Hull& hull = ConvexSolidAccess::hull(solid);
        EXPECT_EQ(hull.vertex_count(), 8u);
        EXPECT_EQ(hull.edges.size(), 12u);
        EXPECT_EQ(hull.faces.size(), 6u);
        expect_valid(solid);
    }
}

TEST(ConvexSolid, EdgesThatFaceHalves) {
    const Soup whole = soup_of_box({0, 0, 0}, {1, 1, 1}), fine = soup_of_box({0, 0, 0}, {1, 1, 1}, 3);
    Soup mixed;
    for (std::size_t i = 2; i < whole.triangles.size(); ++i) {
        const auto& t = whole.triangles[i];
        mixed.add(whole.vertices[t[2]], whole.vertices[t[1]], whole.vertices[t[0]]);
    }
    for (std::size_t i = 0; i < 18; ++i) {
        const auto& t = fine.triangles[i];
        mixed.add(fine.vertices[t[0]], fine.vertices[t[1]], fine.vertices[t[2]]);
    }
    const ConvexSolid solid(mixed.mesh());
    EXPECT_EQ(ConvexSolidAccess::hull(solid).vertex_count(), 8u);
    expect_valid(solid);
    // Each edge is named by the least side that lies on it.
    for (const Hull::Edge& edge : ConvexSolidAccess::hull(solid).edges) EXPECT_LT(edge.name.triangle, 10u);
}

// The triangle and vertex that the error names.
template <class Make>
void expect_not_convex(const Mesh& mesh, Make&& make) {
    try {
        make();
        FAIL();
    } catch (const NotSolid& error) {
        EXPECT_EQ(error.reason, NotSolid::Reason::dent);
        const Triangle& t = mesh.triangles()[error.triangle];
        EXPECT_EQ(error.vertices[0], t[static_cast<std::size_t>(error.corner)]);
        EXPECT_EQ(error.vertices[1], t[static_cast<std::size_t>(error.corner + 1) % 3]);
        const auto v = mesh.vertices();
        EXPECT_NE(orient3d(v[t[0]], v[t[1]], v[t[2]], v[error.beyond]), Sign::zero);
    }
}

TEST(ConvexSolid, WhatIsNot) {
    EXPECT_INVALID(ConvexSolid{MeshPtr()}, Argument::null);
    Soup dented;  // an octahedron with one vertex inside
    dented.add_box({0, 0, 0}, {3, 3, 3});
    for (Vec3& v : dented.vertices) {
        if (v == Vec3(3, 3, 3)) v = Vec3(1, 1, 1);
    }
    expect_not_convex(*dented.mesh(), [&] { ConvexSolid{dented.mesh()}; });

    Soup hollow = soup_of_box({0, 0, 0}, {3, 3, 3});
    hollow.add_box({1, 1, 1}, {2, 2, 2});
    expect_not_convex(*hollow.mesh(), [&] { ConvexSolid{hollow.mesh()}; });

    Soup two = soup_of_box({0, 0, 0}, {1, 1, 1});
    two.add_box({2, 0, 0}, {3, 1, 1});
    expect_not_convex(*two.mesh(), [&] { ConvexSolid{two.mesh()}; });

    Soup corners = soup_of_box({0, 0, 0}, {1, 1, 1});
    corners.add_box({1, 1, 1}, {2, 2, 2});
    expect_not_convex(*corners.mesh(), [&] { ConvexSolid{corners.mesh()}; });

    Soup along_an_edge = soup_of_box({0, 0, 0}, {1, 1, 1});
    along_an_edge.add_box({1, 1, 0}, {2, 2, 1});
    expect_not_convex(*along_an_edge.mesh(), [&] { ConvexSolid{along_an_edge.mesh()}; });

    // An L whose long sides face halves.
    Soup bent;
    for (const Vec3& low : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) bent.add_box(low, low + Vec3(1, 1, 1));
    Soup border;  // faces of two cells cancel
    const auto center = [&](std::size_t i) -> Vec3 {
        const auto& t = bent.triangles[i & ~std::size_t{1}];
        return bent.vertices[t[0]] + bent.vertices[t[2]];
    };
    for (std::size_t i = 0; i < bent.triangles.size(); ++i) {
        int same = 0;
        for (std::size_t k = 0; k < bent.triangles.size(); k += 2) same += center(k) == center(i);
        const auto& t = bent.triangles[i];
        if (same == 1) border.add(bent.vertices[t[0]], bent.vertices[t[1]], bent.vertices[t[2]]);
    }
    expect_not_convex(*border.mesh(), [&] { ConvexSolid{border.mesh()}; });

    Soup flat;
    flat.add(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0));
    EXPECT_INVALID(Solid{flat.mesh()}, NotSolid::Reason::no_interior);
    EXPECT_THROW(ConvexSolid{soup_of_box({0, 0, 0}, {1, 1, 0}).mesh()}, Error);
}

TEST(ConvexHull, OfPointsOnEllipsoids) {
    scenes::Random random(3);
    for (const int count : {4, 5, 12, 60, 700}) {
        const auto points = on_ellipsoid(random, count, {3, 1, 0.01});
        const ConvexSolid solid{std::span<const Vec3>(points)};
        EXPECT_EQ(ConvexSolidAccess::hull(solid).vertex_count(), static_cast<std::size_t>(count));
        expect_valid(solid);
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(solid.mesh().vertices()[i], points[i]);
    }
}

// A lattice: all but the corners lie inside faces, edges, or the box, and there are equal points, too.
TEST(ConvexHull, OfLattices) {
    std::vector<Vec3> points;
    for (int x = 0; x < 9; ++x) {
        for (int y = 0; y < 7; ++y) {
            for (int z = 0; z < 5; ++z) points.emplace_back((x * 4) % 9 - 4, (y * 3) % 7 - 3, (z * 2) % 5 - 2);
        }
    }
    const std::vector<Vec3> once = points;
    points.insert(points.end(), once.begin(), once.end());
    const std::shared_ptr<const Mesh> mesh = convex_hull(points);
    EXPECT_EQ(mesh->vertices().size(), 8u);
    EXPECT_EQ(mesh->triangles().size(), 12u);
    EXPECT_TRUE(std::ranges::is_sorted(mesh->triangles()));
    for (const Triangle& t : mesh->triangles()) EXPECT_EQ(t[0], std::min({t[0], t[1], t[2]}));
    expect_valid(ConvexSolid(mesh));
}

TEST(ConvexHull, ThousandsInOnePlane) {
    scenes::Random random(5);
    std::vector<Vec3> points;
    for (int i = 0; i < 4000; ++i) {
        points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), i % 2);
        points.emplace_back(random.uniform(-1, 1), -1, random.uniform(0, 1));
    }
    // A polygon of many corners: points of a parabola of integers.
    for (int i = -1500; i <= 1500; ++i) points.emplace_back(i, i * i, 5);
    const ConvexSolid solid{std::span<const Vec3>(points)};
    const Hull& hull = ConvexSolidAccess::hull(solid);
    EXPECT_TRUE(std::ranges::any_of(hull.faces, [](const Hull::Face& face) { return face.count == 3001; }));
    ASSERT_EQ(hull.vertex_count() + hull.faces.size(), hull.edges.size() + 2);
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfPoints) {
    scenes::Random random(7);
    std::vector<Vec3> points = on_ellipsoid(random, 40);
    for (int x = -2; x <= 2; ++x) {
        for (int y = -2; y <= 2; ++y) {
            for (int z = -2; z <= 2; ++z) points.emplace_back(0.5 * x, 0.5 * y, 0.5 * z);
        }
    }
    const auto faces_of = [](const std::shared_ptr<const Mesh>& mesh) {
        const ConvexSolid solid(mesh);
        std::set<std::set<std::array<double, 3>>> faces;
        const Hull& hull = ConvexSolidAccess::hull(solid);
        for (std::uint32_t f = 0; f < hull.faces.size(); ++f) {
            std::set<std::array<double, 3>> face;
            for (const Hull::Neighbor& n : hull.cycle_of(f)) {
                const Vec3 p = point_of(solid, n.vertex);
                face.insert({p[0], p[1], p[2]});
            }
            faces.insert(face);
        }
        return faces;
    };
    const auto expected = faces_of(convex_hull(points));
    for (int round = 0; round < 5; ++round) {
        for (std::size_t i = points.size() - 1; i > 0; --i) {
            std::swap(points[i], points[random.below(static_cast<std::uint32_t>(i + 1))]);
        }
        EXPECT_EQ(faces_of(convex_hull(points)), expected);
    }
}

TEST(ConvexHull, OfAnyDoubles) {
    scenes::Random random(13);
    for (const int exponent : {-1074, -1022, -900, 0, 900, 1023}) {
        std::vector<Vec3> points;
        for (int i = 0; i < 30; ++i) {
            Vec3 p;
            for (int k = 0; k < 3; ++k)
                p[k] = std::ldexp(static_cast<int>(random.below(9)) - 4, exponent - 2 * (exponent > 0));
            points.push_back(p);
        }
        expect_valid(ConvexSolid{std::span<const Vec3>(points)});
    }
    std::vector<Vec3> mixed;
    for (int i = 0; i < 20; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k)
            p[k] = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(2000)) - 1000);
        mixed.push_back(p);
    }
    expect_valid(ConvexSolid{std::span<const Vec3>(mixed)});
}

// Of the distance of a point from the plane through three others.
Rational distance_squared(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const auto minus = [](const Vec3& x, const Vec3& y) {
        return std::array<Rational, 3>{Rational(x[0]) - y[0], Rational(x[1]) - y[1], Rational(x[2]) - y[2]};
    };
    const auto u = minus(b, a), v = minus(c, a), w = minus(p, a);
    Rational height = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const Rational n = u[i] * v[j] - u[j] * v[i];
        height += n * w[k];
        length += n * n;
    }
    return height * height / length;
}

// Checks that `rounded` is the double that is nearest to the root.
void expect_root_of(const Rational& square, double rounded) {
    const Rational below = (Rational(rounded) + std::nextafter(rounded, 0)) / 2;
    const Rational above = (Rational(rounded) + std::nextafter(rounded, 1)) / 2;
    EXPECT_LE(below * below, square);
    EXPECT_GE(above * above, square);
}

// Boxes turned at random, their corners rounded to floats. The halves of most rectangles are not in one plane.
TEST(ConvexSolid, TurnedBoxesHaveDentsThatAreNamed) {
    Random random(40);
    int dented = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 half(random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2));
        const Soup whole = soup_of_box(-half, half);
        const Mat3 R = random.turned().R;
        std::vector<Vec3> corners;
        for (const Vec3& v : whole.vertices) corners.push_back((R * v).cast<float>().cast<double>());
        const auto mesh = Mesh::create(corners, whole.triangles);
        try {
            const ConvexSolid solid(mesh);
        } catch (const NotSolid& error) {
            ASSERT_EQ(error.reason, NotSolid::Reason::dent);
            ++dented;
            const Triangle& t = mesh->triangles()[error.triangle];
            const Rational depth = distance_squared(corners[t[0]], corners[t[1]], corners[t[2]], corners[error.beyond]);
            expect_root_of(depth, error.depth);
            EXPECT_LT(error.depth, 0x1p-21);
            EXPECT_NE(std::string(error.what()).find("ConvexSolid(points)"), std::string::npos);
        }
        const ConvexSolid hull{std::span<const Vec3>(corners)};
        EXPECT_EQ(ConvexSolidAccess::hull(hull).vertex_count(), 8u);
    }
    EXPECT_GT(dented, 340);
}

TEST(ConvexHull, WhatHasNone) {
    const auto hull_of = [](std::vector<Vec3> points) { return convex_hull(points); };
    EXPECT_INVALID(hull_of({}), NotSolid::Reason::no_interior);
    try {
        hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, std::nan(""), 0}});
        FAIL();
    } catch (const InvalidMesh& error) {
        EXPECT_EQ(error.reason, InvalidMesh::Reason::vertex);
        EXPECT_EQ(error.vertex, 3u);
        EXPECT_EQ(error.axis, 1);
    }
}

}  // namespace
}  // namespace ecods
