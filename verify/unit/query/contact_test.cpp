// What bodies share and which features are close, on bodies whose answer is known, and against the oracle.

#include "ecods/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "oracle/distance.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

oracle::MeshDistances truth(const MeshShape& a, const Pose& pose_a, const MeshShape& b, const Pose& pose_b) {
    return {{a.mesh().vertices(), a.mesh().triangles(), pose_a}, {b.mesh().vertices(), b.mesh().triangles(), pose_b}};
}

TEST(Contact, IntersectionsAreThoseOfTheOracle) {
    scenes::Random random(31);
    QueryMemory memory;
    const MeshShape torus(scenes::torus(9, 7, 0.4));
    std::size_t pair_count = 0;
    for (int i = 0; i < 30; ++i) {
        Pose a, b;
        if (i % 3 != 0) b.R = random.rotation().toRotationMatrix();
        b.t = i % 3 == 0 ? Vec3(0.5 * random.below(4), 0, 0) : Vec3(0.8 * random.direction());
        const oracle::MeshDistances meshes = truth(torus, a, torus, b);
        const std::vector<TriangleIntersection> all = intersections({torus, a}, {torus, b}, memory);
        const std::vector<TrianglePair> pairs = intersecting_triangles({torus, a}, {torus, b}, memory);
        ASSERT_EQ(all.size(), pairs.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            ASSERT_EQ(all[k].triangles, pairs[k]);
            const std::vector<oracle::ExactPoint> corners = meshes.intersection(pairs[k].a, pairs[k].b);
            ASSERT_EQ(all[k].shared.corner_count, corners.size());
            for (std::size_t c = 0; c < corners.size(); ++c) {
                ASSERT_EQ(all[k].shared.corners()[c], corners[c].nearest());
            }
            ++pair_count;
        }
    }
    EXPECT_GT(pair_count, 500u);
}

// A cube's lowest corner over the middle of another's top face: eight triangles have that corner or an edge of it, and
// one pair of features is within the gap.
TEST(Contact, FeaturesOfManyTrianglesAreNamedOnce) {
    const MeshShape cube(scenes::cube(0.5)),
        octahedron(Mesh::create({Vec3(0.125, 0.25, 0), Vec3(1, 0, 1), Vec3(0, 1, 1), Vec3(-1, 0, 1), Vec3(0, -1, 1)},
                                {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
    Pose above;
    above.t = Vec3(0, 0, 0.75);
    QueryMemory memory;
    const auto triangles = close_triangles({cube, Pose{}}, {octahedron, above}, 0.25, memory);
    const auto features = close_features({cube, Pose{}}, {octahedron, above}, 0.25, memory);
    EXPECT_EQ(triangles.size(), 4u);
    ASSERT_EQ(features.size(), 1u);
    EXPECT_EQ(features[0].closest.kind, ClosestKind::vertex_face);
    EXPECT_EQ(features[0].closest.triangles(), triangles[0].triangles());
    EXPECT_EQ(features[0].closest.distance, 0.25);
    ASSERT_TRUE(features[0].direction);
    EXPECT_EQ(*features[0].direction, Vec3(0, 0, 1));
    EXPECT_TRUE(close_features({cube, Pose{}}, {octahedron, above}, std::nextafter(0.25, 0), memory).empty());
}

// Every pair of features of close_triangles is there, by the coordinates of its corners, and none twice. Every triangle
// here has vertices of its own.
TEST(Contact, FeaturesAreThoseOfCloseTriangles) {
    const auto corners_of = [](const Feature& f, const MeshShape& shape) {
        const Triangle& t = shape.mesh().triangles()[f.triangle];
        std::vector<std::array<double, 3>> corners;
        for (std::uint32_t k = 0; k <= static_cast<std::uint32_t>(f.kind); ++k) {
            const Vec3& v = shape.mesh().vertices()[t[(f.corner + k) % 3]];
            corners.push_back({v[0], v[1], v[2]});
        }
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    const auto whole = scenes::torus(6, 5, 0.4);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Triangle& t : whole->triangles()) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const std::uint32_t v : t) vertices.push_back(whole->vertices()[v]);
        triangles.push_back({first, first + 1, first + 2});
    }
    const MeshShape soup(Mesh::create(vertices, triangles));
    QueryMemory memory;
    for (const double gap : {0.5, 0.125, 0.0}) {
        Pose a, b;
        b.t = Vec3(0, 0, 0.8 + gap);
        const auto all = close_triangles({soup, a}, {soup, b}, 0.3, memory);
        const auto features = close_features({soup, a}, {soup, b}, 0.3, memory);
        std::vector<std::pair<ClosestKind, std::array<std::vector<std::array<double, 3>>, 2>>> expected, found;
        for (const ClosestPoints& c : all) expected.push_back({c.kind, {corners_of(c.a, soup), corners_of(c.b, soup)}});
        for (const CloseFeatures& f : features) {
            found.push_back({f.closest.kind, {corners_of(f.closest.a, soup), corners_of(f.closest.b, soup)}});
            EXPECT_EQ(f.direction.has_value(), f.closest.kind != ClosestKind::intersecting);
            if (!f.direction) continue;
            const Vec3 way = f.closest.point_b - f.closest.point_a;
            EXPECT_LT((way - f.closest.distance * *f.direction).norm(), 1e-12);
        }
        std::sort(expected.begin(), expected.end());
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        EXPECT_LT(found.size(), all.size() + (all.empty() ? 1 : 0));
        EXPECT_TRUE(
            std::is_sorted(features.begin(), features.end(), [](const CloseFeatures& x, const CloseFeatures& y) {
                return x.closest.triangles() < y.closest.triangles();
            }));
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
    }
    EXPECT_THROW(close_features({soup, Pose{}}, {soup, Pose{}}, -1, memory), InvalidDistance);
    EXPECT_THROW(close_features({soup, Pose{}}, {soup, Pose{}}, std::numeric_limits<double>::infinity(), memory),
                 InvalidDistance);
}

}  // namespace
}  // namespace ecods
