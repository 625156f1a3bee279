// Bodies that lie face on face under one rotation: planes decide for all triangles of theirs, and the answers are those
// of the oracle, which knows no planes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ecods/intersection.hpp"
#include "oracle/oracle.hpp"
#include "query/shape/mesh_tree.hpp"
#include "scenes/flush_parts.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/expect_intersection.hpp"

namespace ecods {
namespace {

using scenes::plate;

// The relation of the bodies, after all three queries in both orders are found to be right.
Relation right_relation(const MeshShape& a, const Pose& pose_a, const MeshShape& b, const Pose& pose_b,
                        QueryMemory& memory) {
    expect_right(a, pose_a, b, pose_b, memory);
    return relation(Posed<MeshShape>{a, pose_a}, Posed<MeshShape>{b, pose_b}, memory);
}

// Meshes in one.
std::shared_ptr<const Mesh> together(const std::vector<std::pair<std::shared_ptr<const Mesh>, Vec3>>& parts) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const auto& [mesh, offset] : parts) {
        const auto base = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3& v : mesh->vertices()) vertices.push_back(v + offset);
        for (const auto& [i, j, k] : mesh->triangles()) triangles.push_back({base + i, base + j, base + k});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

double step(double x, int ulps) {
    for (; ulps > 0; --ulps) x = std::nextafter(x, INFINITY);
    for (; ulps < 0; ++ulps) x = std::nextafter(x, -INFINITY);
    return x;
}

Mat3 any_matrix(scenes::Random& random, int kind) {
    Mat3 R = random.rotation().toRotationMatrix();
    if (kind == 1) R *= 3;
    if (kind == 2) R.col(0) *= -1;                        // mirrored
    if (kind == 3) R = R * Vec3(1, 2, 0.5).asDiagonal();  // not orthogonal
    if (kind == 4) R.col(static_cast<int>(random.below(3))).setZero();
    if (kind == 5) R *= -0x1p-30;
    if (kind == 6) R << 1, 2, 2, 2, 1, -2, -2, 2, -1;  // contact is exact
    return R;
}

// Bodies on top of each other, with the translation at neighbours of the rounded place.
void place_neighbours(const std::shared_ptr<const Mesh>& lower, const std::shared_ptr<const Mesh>& upper, double height,
                      int count, std::uint32_t seed, std::set<Relation>& seen, QueryMemory& memory) {
    const MeshShape a(lower), b(upper);
    scenes::Random random(seed);
    for (int i = 0; i < count; ++i) {
        Pose pose_a{any_matrix(random, i % 7), {}};
        for (int k = 0; k < 3; ++k) pose_a.t[k] = random.uniform(-4, 4) * pose_a.R.cwiseAbs().maxCoeff();
        Pose pose_b = pose_a;
        const double x = 0.25 * random.below(9) - 1, y = 0.25 * random.below(9) - 1;
        pose_b.t += (pose_a.R.col(0) * x + pose_a.R.col(1) * y) + pose_a.R.col(2) * height;
        for (int k = 0; k < 3; ++k) {
            if (random.below(2) == 0) pose_b.t[k] = step(pose_b.t[k], static_cast<int>(random.below(5)) - 2);
        }
        seen.insert(right_relation(a, pose_a, b, pose_b, memory));
        if (testing::Test::HasFailure()) FAIL() << "case " << i << " of seed " << seed;
    }
}

TEST(FlushFaces, NeighboursOfContact) {
    QueryMemory memory;
    std::set<Relation> seen;
    place_neighbours(plate(1, 1), plate(1, 1), 2, 300, 1, seen, memory);
    place_neighbours(plate(3, 0.25), plate(2, 0.125), 0.375, 100, 2, seen, memory);
    place_neighbours(plate(1, 1), together({{plate(1, 1), Vec3::Zero()}, {plate(1, 1), {3, 0, 0}}}), 2, 100, 3, seen,
                     memory);
    EXPECT_EQ(seen.size(), 3u) << "apart, touching and crossing";
    EXPECT_GT(memory.counts().stages.plane_passes, 1000u);
}

// The faces in contact are not at an end of their bodies: what is apart there may meet elsewhere.
TEST(FlushFaces, PlanesInTheMidstOfBodies) {
    const auto cube = plate(1, 1), thin = plate(2, 0.0625);
    // A step on each, at different heights: the upper's lower step and the lower's higher one.
    const auto stairs = together({{cube, Vec3::Zero()}, {thin, {1.5, 0, 0.5}}});
    const auto hooks = together({{cube, Vec3::Zero()}, {thin, {-1.5, 0, -1.25}}, {thin, {1.5, 0, -1.5}}});
    QueryMemory memory;
    std::set<Relation> seen;
    place_neighbours(stairs, hooks, 2, 150, 4, seen, memory);
    place_neighbours(hooks, stairs, -2, 150, 5, seen, memory);
    EXPECT_EQ(seen.size(), 3u);
    EXPECT_GT(memory.counts().stages.plane_passes, 1000u);
}

// A plane that separates most of a body from the other one, but for one corner behind it.
TEST(FlushFaces, OneCornerBehindThePlane) {
    QueryMemory memory;
    scenes::Random random(6);
    const MeshShape below(plate(2, 1));
    for (int i = 0; i < 100; ++i) {
        const auto block = plate(2, 1);
        std::vector<Vec3> vertices(block->vertices().begin(), block->vertices().end());
        std::vector<Triangle> triangles(block->triangles().begin(), block->triangles().end());
        const auto at = static_cast<std::uint32_t>(vertices.size());
        const double depth = std::ldexp(1.0, -static_cast<int>(random.below(50)));
        vertices.insert(vertices.end(), {{0.25, 0.25, -1 - depth}, {0.5, 0.25, 0}, {0.25, 0.5, 0}});
        triangles.push_back({at, at + 1, at + 2});
        const MeshShape above(Mesh::create(vertices, triangles));
        Pose a{random.rotation().toRotationMatrix(), {1, 2, 3}};
        Pose b = a;
        b.t += a.R.col(2) * 2;
        for (int k = 0; k < 3; ++k) b.t[k] = step(b.t[k], static_cast<int>(random.below(5)) - 2);
        right_relation(below, a, above, b, memory);
        ASSERT_FALSE(testing::Test::HasFailure()) << "case " << i;
    }
}

// The memory of one query knows nothing of the next: other bodies, other planes, the same numbers.
TEST(FlushFaces, QueriesDoNotKnowEachOther) {
    QueryMemory memory;
    scenes::Random random(7);
    const MeshShape cube(plate(1, 1)), flat(plate(1, 0.5));
    const Mat3 R = random.rotation().toRotationMatrix();
    for (int i = 0; i < 200; ++i) {
        const MeshShape& b = i % 2 == 0 ? cube : flat;
        const double height = (i % 2 == 0 ? 2 : 1.5) + (i % 3 == 0 ? -0x1p-40 : i % 3 == 1 ? 0x1p-40 : 0);
        const Pose pose_a{R, {0.5, 0.25, 0.125}}, pose_b{R, pose_a.t + R.col(2) * height};
        ASSERT_EQ(intersects({cube, pose_a}, {b, pose_b}, memory), [&] {
            QueryMemory own;
            return intersects({cube, pose_a}, {b, pose_b}, own);
        }());
        const Pose away{R, pose_a.t + R.col(2) * 2.5 + R.col(0) * 0.25};
        ASSERT_EQ(intersects({cube, pose_a}, {b, away}, memory), false);
    }
}

CoplanarGroups groups_of(const std::shared_ptr<const Mesh>& mesh) {
    return MeshShapeAccess::groups(MeshShape(mesh));
}

TEST(CoplanarGroups, FacesOfABox) {
    const CoplanarGroups groups = groups_of(plate(2, 1));
    ASSERT_EQ(groups.first.size(), 6u);
    std::array<int, 6> sizes{};
    for (const std::uint32_t group : groups.of_triangle) {
        ASSERT_LT(group, 6u);
        ++sizes[group];
    }
    EXPECT_EQ(std::set<int>(sizes.begin(), sizes.end()), (std::set<int>{4, 8}));
    for (const std::int8_t side : groups.side) EXPECT_EQ(side, -1) << "normals point outwards";
}

TEST(CoplanarGroups, OnlyExactlyCoplanarProperTrianglesOfOneTurn) {
    const double off = std::nextafter(1.0, 2.0);
    // Two in z = 1; one turned over; one an ulp off; one of no area; one in z = 1 far away.
    const auto mesh =
        Mesh::create({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, off}, {2, 0, 1}, {9, 9, 1}, {5, 9, 1}, {9, 3, 0}},
                     {{0, 1, 2}, {1, 4, 2}, {0, 2, 1}, {1, 3, 2}, {0, 1, 4}, {1, 5, 6}, {0, 1, 7}});
    const CoplanarGroups groups = groups_of(mesh);
    ASSERT_EQ(groups.first.size(), 1u);
    EXPECT_EQ(groups.first[0], 0u);
    constexpr auto none = CoplanarGroups::none;
    EXPECT_EQ(groups.of_triangle, (std::vector<std::uint32_t>{0, 0, none, none, none, 0, none}));
    EXPECT_EQ(groups.side[0], 0) << "corners on both sides";
    EXPECT_TRUE(groups_of(scenes::sphere(7, 5)).of_node.size() <= 100u);
}

// Groups against the definition, on meshes with many coplanar triangles, of long and huge coordinates.
TEST(CoplanarGroups, AreWhatTheySay) {
    scenes::Random random(8);
    for (const double scale : {1.0, 0.1, 1e-300, 1e200, 1e-308, 1e308}) {
        const auto base = together({{plate(3, 0.25), Vec3::Zero()}, {plate(2, 1), {3, 1, 0.75}}});
        const auto mesh = scenes::mapped(*base, [&](const Vec3& v) -> Vec3 { return v * (scale / 8); });
        const auto vertices = mesh->vertices();
        const CoplanarGroups groups = groups_of(mesh);
        for (std::size_t i = 0; i < groups.of_triangle.size(); ++i) {
            if (groups.of_triangle[i] == CoplanarGroups::none) continue;
            const Triangle& p = mesh->triangles()[groups.first[groups.of_triangle[i]]];
            for (const std::uint32_t v : mesh->triangles()[i])
                ASSERT_EQ(orient3d(vertices[p[0]], vertices[p[1]], vertices[p[2]], vertices[v]), Sign::zero);
        }
        for (std::size_t g = 0; g < groups.first.size(); ++g) {
            const Triangle& p = mesh->triangles()[groups.first[g]];
            bool is_positive = false, is_negative = false;
            for (const Vec3& v : vertices) {
                const Sign s = orient3d(vertices[p[0]], vertices[p[1]], vertices[p[2]], v);
                is_positive |= s == Sign::positive;
                is_negative |= s == Sign::negative;
            }
            ASSERT_EQ(groups.side[g], is_positive && is_negative ? 0 : is_positive ? 1 : -1);
        }
    }
}

// Needles in one plane of which doubles get the turn wrong (Kettner and others, Classroom examples of robustness
// problems in geometric computations, 2008).
TEST(CoplanarGroups, KnowTheTurnOfNeedles) {
    std::vector<Vec3> vertices = {{0, 0, 1}, {30, 0, 1}, {0, 30, 1}, {12, 12, 1}, {24, 24, 1}};
    std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 1}};
    for (int i = 0; i < 64; ++i) {
        for (int k = 0; k < 64; ++k) {
            const auto at = static_cast<std::uint32_t>(vertices.size());
            vertices.emplace_back(0.5 + i * 0x1p-53, 0.5 + k * 0x1p-53, 1);
            triangles.push_back({at, 3, 4});
        }
    }
    const auto turn = [&](std::uint32_t triangle) {
        const auto [a, b, c] = triangles[triangle];
        return orient2d(vertices[a].head<2>(), vertices[b].head<2>(), vertices[c].head<2>());
    };
    const CoplanarGroups groups = groups_of(Mesh::create(vertices, triangles));
    std::size_t wrong_in_doubles = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto [a, b, c] = triangles[i];
        const double z = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).z();
        wrong_in_doubles += z != 0 && (z > 0 ? Sign::positive : Sign::negative) != turn(i);
        if (groups.of_triangle[i] == CoplanarGroups::none) continue;
        ASSERT_NE(turn(i), Sign::zero);
        ASSERT_EQ(turn(i), turn(groups.first[groups.of_triangle[i]]));
    }
    EXPECT_GT(wrong_in_doubles, 10u);
}

}  // namespace
}  // namespace ecods
