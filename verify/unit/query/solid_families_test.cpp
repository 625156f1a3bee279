// Solids of every family of solid_cases.hpp beside the oracle and beside how they were made, and what must not matter.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "scenes/lattice_bodies.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

using scenes::Random;
using scenes::SolidCase;

int cases_of(std::string_view family) {
    if (family == "polycubes" || family == "common pose" || family == "singular") return 8;
    return family == "contacts" || family == "nudged" ? 40 : 20;
}

TEST(SolidFamilies, AsTheOracle) {
    std::map<std::string, int> relations;
    std::map<Relation, int> surfaces;
    std::size_t on_count = 0;
    QueryMemory memory;
    PairWitness none;
    scenes::for_each_case(scenes::solid_families(), 1, cases_of, [&](const SolidCase& made) {
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_whether_solid(*made.a.mesh)));
        const judge::Judged<SolidCase> judged(made);
        ++surfaces[judged.truth.surface_relation()];
        on_count += judged.truth.on_count();
        expect_right(made, judged, memory, none, relations);
    });
    expect_each(relations, 6, 5);
    EXPECT_EQ(surfaces.size(), 4U);
    for (const auto& [relation, count] : surfaces) EXPECT_GT(count, 5) << relation;
    EXPECT_GT(on_count, 300U);
}

// Neither instruction sets nor rounding modes matter, nor what a question leaves in the memory. Solids are made in the
// environment, too.
TEST(SolidFamilies, TheSameInEveryEnvironment) {
    scenes::for_each_case(scenes::solid_families(), 2, 2, [](const SolidCase& made) {
        const judge::Judged<SolidCase> judged(made);
        const auto ask = [&] {
            QueryMemory memory;
            const Solid new_a(made.a.mesh), new_b(made.b.mesh);
            return judged.truth.with({new_a, made.a.pose}, {new_b, made.b.pose}).ask(memory);
        };
        environment::in_each_environment(ask, [](const auto& wrong, const std::string& where) {
            SCOPED_TRACE(where);
            ASSERT_NO_FATAL_FAILURE(expect_none(wrong));
        });
    });
}

// The order of triangles and of their corners, and whether corners that are equal are one vertex.
TEST(SolidFamilies, TheOrderOfTrianglesDoesNotMatter) {
    Random random(3);
    QueryMemory memory;
    scenes::for_each_case(scenes::solid_families(), random, 10, [&](const SolidCase& made) {
        const auto shuffled = [&](const std::shared_ptr<const Mesh>& mesh) {
            std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
            std::vector<Triangle> triangles(mesh->triangles().begin(), mesh->triangles().end());
            scenes::shuffle(vertices, triangles, random);
            return Mesh::create(std::move(vertices), std::move(triangles));
        };
        const Solid a(made.a.mesh), b(made.b.mesh), c(shuffled(made.a.mesh)), d(shuffled(made.b.mesh));
        ASSERT_EQ(relation({c, made.a.pose}, {d, made.b.pose}, memory),
                  relation({a, made.a.pose}, {b, made.b.pose}, memory));
        ASSERT_EQ(relation({*surface_of(c), made.a.pose}, {d, made.b.pose}, memory),
                  relation({*surface_of(a), made.a.pose}, {b, made.b.pose}, memory));
        for (const Vec3& point : made.known_points()) {
            ASSERT_EQ(locate(point, {a, made.a.pose}, memory).side, locate(point, {c, made.a.pose}, memory).side);
        }
    });
}

// A solid is equal to itself at a pose, however its numbers are written.
TEST(SolidFamilies, EveryOneWithItself) {
    Random random(4);
    QueryMemory memory;
    const auto count = [](std::string_view family) {
        const bool is_empty = family == "no solid area", is_flat = family == "singular";
        return is_empty || is_flat ? 0 : 10;
    };
    scenes::for_each_case(scenes::solid_families(), random, count, [&](const SolidCase& made) {
        const Solid a(made.a.mesh);
        ASSERT_EQ(relation({a, made.a.pose}, {a, made.a.pose}, memory), Relation::equal);
        Pose other = made.a.pose;
        for (double& x : other.R.reshaped()) x = x == 0 ? -x : x;
        ASSERT_EQ(relation({a, made.a.pose}, {a, other}, memory), Relation::equal);
    });
}

// A triangle through the middle of an edge, or with a corner or a side there.
std::shared_ptr<const Mesh> triangle_at_edge(const scenes::LatticeMesh& mesh, Random& random) {
    const auto vertex = [&](std::uint32_t i) {
        return Vec3(mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]);
    };
    const Triangle& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const Vec3 p = vertex(t[0]), q = vertex(t[1]), middle = 0.5 * (p + q), part = 0.125 * (q - p);
    const Vec3 u = 0.5 * scenes::lattice_point(random, 2);
    const Vec3 v = random.below(3) == 0 ? Vec3(0.5 * scenes::lattice_point(random, 2)) : Vec3(-u);
    return Mesh::create({middle + u, middle + v + part, middle + v - part}, {{0, 1, 2}});
}

// Triangles of a few lattice points beside solids of the lattice: degenerate ones, and ones that are in faces or edges.
TEST(SolidFamilies, SurfacesThatBoundNothing) {
    Random random(5);
    QueryMemory memory;
    std::map<Relation, int> counts;
    for (int i = 0; i < 800; ++i) {
        SCOPED_TRACE(i);
        const auto& all = scenes::fixed_contacts();
        const auto& recipe = all[random.below(static_cast<std::uint32_t>(all.size()))];
        const scenes::PosedMesh body = scenes::place(recipe.a, {}, 0, random);
        const Solid solid(body.mesh);
        const MeshShape soup(i % 2 == 0 ? triangle_at_edge(recipe.a, random)
                                        : scenes::lattice_mesh(random, 3, 3, i % 4 == 1));
        const oracle::Soup of_solid{body.mesh->vertices(), body.mesh->triangles(), body.pose};
        const oracle::Soup of_surface{soup.mesh().vertices(), soup.mesh().triangles(), Pose()};
        const auto expected = oracle::surface_relation(of_surface, of_solid);
        ++counts[expected];
        const Posed<MeshShape> of_soup(soup, Pose()), posed(solid, body.pose);
        ASSERT_EQ(relation(of_soup, posed, memory), expected) << recipe.name;
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_of_common_points(of_soup, posed, expected, memory)));
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_of_common_points(posed, of_soup, expected, memory)));
    }
    EXPECT_EQ(counts.size(), 4U);
    for (const auto& [relation, count] : counts) EXPECT_GE(count, 20) << relation;
}

// A solid without a triangle, with one twice, or with a vertex elsewhere.
std::shared_ptr<const Mesh> spoilt(const Mesh& mesh, Random& random) {
    std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
    std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
    const auto any = [&](const auto& list) { return random.below(static_cast<std::uint32_t>(list.size())); };
    const std::uint32_t choice = random.below(4);
    if (choice == 0 && triangles.size() > 1) triangles.erase(triangles.begin() + any(triangles));
    if (choice == 1) triangles.push_back(triangles[any(triangles)]);
    if (choice == 2) vertices[any(vertices)] = vertices[any(vertices)];
    if (choice == 3) vertices[any(vertices)] = 0.5 * vertices[any(vertices)] + 0.5 * vertices[any(vertices)];
    return Mesh::create(std::move(vertices), std::move(triangles));
}

TEST(SolidFamilies, WhatIsNoSolidIsNamedAsTheOracleDoes) {
    Random random(6);
    std::array<int, 3> counts{};  // solids or nothing, open ones, ones that intersect themselves
    scenes::for_each_case(scenes::solid_families(), random, 25, [&](const SolidCase& made) {
        std::shared_ptr<const Mesh> mesh = made.a.mesh;
        for (int times = scenes::hard::integer(random, 1, 3); times > 0; --times) mesh = spoilt(*mesh, random);
        ++counts[oracle::open_edge(*mesh) ? 1 : oracle::self_intersections(*mesh).empty() ? 0 : 2];
        expect_none(judge::ask_whether_solid(*mesh));
    });
    for (const int count : counts) EXPECT_GT(count, 10);
}

// Two solids as one mesh: proper only where their surfaces share points at most, or sides.
TEST(SolidFamilies, TwoSolidsAsOneMesh) {
    int solid_count = 0;
    for (const scenes::LatticePair& pair : scenes::fixed_contacts()) {
        SCOPED_TRACE(pair.name);
        Random random(7);
        scenes::LatticeMesh both = pair.a;
        both.add(pair.b);
        const scenes::PosedMesh placed = scenes::place(both, {}, 0, random);
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_whether_solid(*placed.mesh)));
        solid_count += oracle::self_intersections(*placed.mesh).empty() ? 1 : 0;
    }
    EXPECT_GT(solid_count, 10);
}

}  // namespace
}  // namespace ecods
