// Bodies that are flat, in one plane: what shares a point is never separated, and slivers beside each other are.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/flush_parts.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/separated_bodies.hpp"

namespace ecods::separating_edges_test {
namespace {

// The filled polygon as slivers that share its corner 0, or as strips.
std::shared_ptr<const Mesh> polygon(std::uint32_t corners, bool is_fan) {
    const auto strips = scenes::flat_polygon(corners);
    if (!is_fan) return strips;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
    return Mesh::create({strips->vertices().begin(), strips->vertices().end()}, std::move(triangles));
}

// A body in a plane across a coordinate axis, the same for all bodies: turned, sheared and mirrored in the plane.
Pose in_plane(scenes::Random& random, int axis, double size) {
    Pose pose;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    for (const int i : {x, y})
        for (const int k : {x, y}) pose.R(i, k) = size * random.uniform(-1, 1);
    return pose;
}

// In one plane triangles are parted by their edges, slivers above all: their edges are short beside the rest, and
// contacts here are as thin as doubles can say.
TEST(SeparatingEdges, NeverSeparateFlatBodiesInContact) {
    scenes::Random random(41);
    for (int i = 0; i < 60; ++i) {
        const int axis = i % 3;
        const double size = i % 5 == 0 ? 0x1p-40 : 1;
        const Body a(scenes::across(*polygon(5 + random.below(20), i % 2 == 0), axis), in_plane(random, axis, 1));
        Body b(scenes::across(*polygon(5 + random.below(20), i % 4 < 2), axis), in_plane(random, axis, size));
        Vec3 direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        direction[axis] = 0;
        bring_into_contact(a, b, direction);
        const std::vector<TrianglePair> pairs = pairs_of(a, b);
        ASSERT_FALSE(pairs.empty());
        for (const TrianglePair& pair : pairs)
            ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << i;
    }
}

// Small triangles at two ends of a large flat mesh: corners are off by as much as all others, which is much beside
// them.
TEST(SeparatingEdges, NeverSeparateSmallTrianglesOfLargeFlatBodiesInContact) {
    scenes::Random random(47);
    const Vec3 end(0.7, 0.6, 0);
    for (int i = 0; i < 400; ++i) {
        const int axis = i % 3;
        const double size = std::exp2(random.uniform(-14, -4));
        const auto chips = [&] {
            std::vector<Vec3> vertices;
            for (const double side : {1.0, -1.0}) {
                for (int k = 0; k < 3; ++k) {
                    const Vec3 aside = k == 0 ? Vec3(1, 0, 0) : Vec3(-1, 2 * k - 3, 0);
                    const Vec3 jitter(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0);
                    vertices.push_back(side * end + size * (aside + jitter));
                }
            }
            return scenes::across(*Mesh::create(std::move(vertices), {{0, 1, 2}, {3, 4, 5}}), axis);
        };
        const Body a(chips(), in_plane(random, axis, 1));
        Body b(chips(), in_plane(random, axis, 1));
        Vec3 there = Vec3::Zero(), direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        for (int k = 0; k < 2; ++k) there[(axis + 1 + k) % 3] = end[k];
        direction[axis] = 0;
        bring_into_contact(a, b, direction, a.pose.R * there - b.pose.R * there);
        for (const TrianglePair& pair : pairs_of(a, b))
            ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << i;
        ASSERT_FALSE(pairs_of(a, b).empty()) << i;
    }
}

// Boxes of slivers in one plane are much too large in it, and the slab of a leaf is there for that.
TEST(SeparatingEdges, SlabsOfFlatSliversLieAcrossThem) {
    const MeshBvh tree = build(*polygon(256, true));
    for (const TreeLeaf& leaf : tree.leaves) {
        float reach = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t lane = 0; lane < tree_width; ++lane)
                for (const auto& corner : leaf.corner)
                    reach = std::max(reach, std::abs(corner[k][lane] - leaf.corner[0][k][0]));
        }
        EXPECT_LT(leaf.slab.high - leaf.slab.low, 0.3f * reach);
    }
}

// Nearly all of what is apart in one plane is separated, though every two slivers have boxes that overlap.
TEST(SeparatingEdges, SeparateSliversOfOnePlane) {
    scenes::Random random(43);
    for (const bool is_fan : {true, false}) {
        const Body a(polygon(100, is_fan), Pose());
        Pose turned;
        turned.R.topLeftCorner<2, 2>() << 0.8, -0.6, 0.6, 0.8;
        Body b(a.mesh, turned);
        bring_into_contact(a, b, Vec3(1, 0, 0));
        b.pose.t[0] += 0x1p-12;
        ASSERT_TRUE(pairs_of(a, b).empty());
        std::size_t through = 0;
        for (std::uint32_t k = 0; k < a.mesh->triangles().size(); ++k)
            for (std::uint32_t l = 0; l < a.mesh->triangles().size(); l += 14)
                through += let_through(a, b, k, l) + let_through(b, a, l, k);
        EXPECT_EQ(through, 0u) << is_fan;
    }
}

// Where two triangles are apart an edge of one of them separates, of either: neither boxes nor slabs do.
TEST(SeparatingEdges, SeparateTrianglesOfOnePlaneByEdgesOfEither) {
    scenes::Random random(53);
    std::size_t apart = 0;
    for (int i = 0; i < 2000; ++i) {
        std::array<Vec3, 3> a, b, larger;
        for (auto* triangle : {&a, &b})
            for (Vec3& v : *triangle) v = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0);
        for (Vec3& v : b) v[0] += 0.7;
        const Vec3 middle = (b[0] + b[1] + b[2]) / 3;
        for (std::size_t k = 0; k < 3; ++k) larger[k] = b[k] + (b[k] - middle) * 0x1p-8;
        if (triangle_triangle({Pose(), a}, {Pose(), larger}) != Relation::apart) continue;
        ++apart;
        const Body x(Mesh::create({a.begin(), a.end()}, {{0, 1, 2}}), Pose());
        const Body y(Mesh::create({b.begin(), b.end()}, {{0, 1, 2}}), Pose());
        EXPECT_FALSE(let_through(x, y, 0, 0)) << i;
        EXPECT_FALSE(let_through(y, x, 0, 0)) << i;
    }
    EXPECT_GT(apart, 500u);
}

}  // namespace
}  // namespace ecods::separating_edges_test
