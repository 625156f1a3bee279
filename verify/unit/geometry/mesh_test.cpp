#include "ecods/mesh.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "ecods/error.hpp"

namespace ecods {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Vec3> corners() {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
}

TEST(Mesh, KeepsWhatItIsGiven) {
    const auto mesh = Mesh::create(corners(), {{0, 1, 2}, {2, 1, 0}});
    EXPECT_EQ(mesh->vertices().size(), 3u);
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->triangles()[1], (Triangle{2, 1, 0}));
    EXPECT_TRUE(mesh->uses_all_vertices());
}

TEST(Mesh, KnowsOfUnusedVertices) {
    auto vertices = corners();
    vertices.push_back({9, 9, 9});
    EXPECT_FALSE(Mesh::create(vertices, {{0, 1, 2}})->uses_all_vertices());
}

TEST(Mesh, RefusesToBeEmpty) {
    EXPECT_THROW(Mesh::create({}, {}), EmptyMesh);
    EXPECT_THROW(Mesh::create(corners(), {}), EmptyMesh);
}

TEST(Mesh, NamesTheVertexThatIsNotFinite) {
    for (const double bad : {nan, infinity, -infinity}) {
        auto vertices = corners();
        vertices[1][2] = bad;
        try {
            Mesh::create(vertices, {{0, 1, 2}});
            FAIL() << "accepted " << bad;
        } catch (const InvalidVertex& error) {
            EXPECT_EQ(error.vertex, 1u);
            EXPECT_EQ(error.axis, 2);
            EXPECT_NE(std::string(error.what()).find("vertex 1, axis 2"), std::string::npos) << error.what();
        }
    }
}

TEST(Mesh, NamesTheIndexThatIsOutOfRange) {
    try {
        Mesh::create(corners(), {{0, 1, 2}, {0, 3, 1}});
        FAIL();
    } catch (const InvalidIndex& error) {
        EXPECT_EQ(error.triangle, 1u);
        EXPECT_EQ(error.corner, 1);
        EXPECT_EQ(error.value, 3u);
        EXPECT_EQ(error.vertex_count, 3u);
    }
}

TEST(Mesh, DigestIsOfCoordinatesAndIndices) {
    const auto mesh = Mesh::create(corners(), {{0, 1, 2}});
    auto same = corners();
    same[0][0] = -0.0;
    EXPECT_EQ(mesh->digest(), Mesh::create(same, {{0, 1, 2}})->digest());
    EXPECT_NE(mesh->digest(), Mesh::create(corners(), {{0, 2, 1}})->digest());
    auto moved = corners();
    moved[0][0] = std::numeric_limits<double>::denorm_min();
    EXPECT_NE(mesh->digest(), Mesh::create(moved, {{0, 1, 2}})->digest());
}

TEST(Mesh, DigestIsTheSameEverywhere) {
    EXPECT_EQ(Mesh::create(corners(), {{0, 1, 2}})->digest(), 4404590610498048754u) << "golden value";
}

}  // namespace
}  // namespace ecods
