#include "ecods/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"

namespace ecods::mesh_test {
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
    EXPECT_INVALID(Mesh::create(std::vector<Vec3>(), {}), InvalidMesh::Reason::empty);
    EXPECT_INVALID(Mesh::create(corners(), {}), InvalidMesh::Reason::empty);
}

TEST(Mesh, NamesTheVertexThatIsNotFinite) {
    for (const double bad : {nan, infinity, -infinity}) {
        auto vertices = corners();
        vertices[1][2] = bad;
        try {
            Mesh::create(vertices, {{0, 1, 2}});
            FAIL() << "accepted " << bad;
        } catch (const InvalidMesh& error) {
            EXPECT_EQ(error.reason, InvalidMesh::Reason::vertex);
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
    } catch (const InvalidMesh& error) {
        EXPECT_EQ(error.reason, InvalidMesh::Reason::index);
        EXPECT_EQ(error.triangle, 1u);
        EXPECT_EQ(error.corner, 1);
        EXPECT_EQ(error.index, 3u);
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

TEST(Mesh, IsMadeOfNumbersOfAnyWidth) {
    const auto expected = Mesh::create(corners(), {{0, 1, 2}, {2, 1, 0}});
    std::vector<double> doubles, apart;
    for (const Vec3& v : corners()) {
        for (int k = 0; k < 3; ++k) doubles.push_back(v[k]);
        if (!apart.empty()) apart.insert(apart.end(), {nan, nan});  // others' numbers between two vertices
        for (int k = 0; k < 3; ++k) apart.push_back(v[k]);
    }
    const std::vector<float> floats(doubles.begin(), doubles.end()), floats_apart(apart.begin(), apart.end());
    const std::vector<std::uint32_t> narrow = {0, 1, 2, 2, 1, 0};
    const std::vector<std::uint64_t> wide(narrow.begin(), narrow.end());
    for (const auto& made :
         {Mesh::create(doubles, narrow), Mesh::create(doubles, wide), Mesh::create(floats, narrow),
          Mesh::create(floats, wide), Mesh::create(apart, narrow, 5), Mesh::create(floats_apart, wide, 5)}) {
        EXPECT_EQ(made->digest(), expected->digest());
        EXPECT_EQ(made->vertices().size(), 3u);
    }
}

// An index that would be right without its upper half is no index.
TEST(Mesh, DoesNotCutWideIndices) {
    const std::vector<double> coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint64_t wide = (std::uint64_t{1} << 32) + 1;
    try {
        Mesh::create(coordinates, std::vector<std::uint64_t>{0, 1, 2, 0, wide, 2});
        FAIL();
    } catch (const InvalidMesh& error) {
        EXPECT_EQ(error.reason, InvalidMesh::Reason::index);
        EXPECT_EQ(error.triangle, 1u);
        EXPECT_EQ(error.corner, 1);
        EXPECT_EQ(error.index, wide);
        EXPECT_EQ(error.vertex_count, 3u);
    }
}

TEST(Mesh, NumbersMakeWholeVerticesAndTriangles) {
    const std::vector<double> coordinates(11, 1.0);
    const std::vector<std::uint32_t> indices = {0, 1, 2, 0};
    const std::span<const std::uint32_t> triangle(indices.data(), 3);
    const std::span<const double> numbers(coordinates);
    EXPECT_INVALID(Mesh::create(numbers, triangle), InvalidMesh::Reason::layout);
    EXPECT_INVALID(Mesh::create(numbers.first(10), triangle), InvalidMesh::Reason::layout);
    EXPECT_INVALID(Mesh::create(numbers, triangle, 2), InvalidMesh::Reason::layout);
    EXPECT_INVALID(Mesh::create(numbers, triangle, 0), InvalidMesh::Reason::layout);
    EXPECT_INVALID(Mesh::create(numbers.first(9), std::span(indices)), InvalidMesh::Reason::layout);
    EXPECT_EQ(Mesh::create(numbers, triangle, 4)->vertices().size(), 3u);
    EXPECT_INVALID(Mesh::create(numbers.first(0), triangle.first(0)), InvalidMesh::Reason::empty);
    std::vector<float> floats(9, 0.0f);
    floats[5] = std::numeric_limits<float>::infinity();
    EXPECT_INVALID(Mesh::create(floats, triangle), InvalidMesh::Reason::vertex);
}

TEST(Mesh, FloatsAreExact) {
    const float tiny = std::numeric_limits<float>::denorm_min(), some = 0.1f;
    const std::vector<float> floats = {tiny, -tiny, 3 * tiny, some, -some, 1e38f, 0.0f, -0.0f, 1.0f};
    const auto mesh = Mesh::create(floats, std::vector<std::uint32_t>{0, 1, 2});
    EXPECT_EQ(mesh->vertices()[0], Vec3(0x1p-149, -0x1p-149, 0x1.8p-148));
    EXPECT_EQ(mesh->vertices()[1], Vec3(double{some}, -double{some}, double{1e38f}));
    EXPECT_TRUE(std::signbit(mesh->vertices()[2][1]));
}

}  // namespace
}  // namespace ecods::mesh_test
