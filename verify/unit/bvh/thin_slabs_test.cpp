// Nodes whose slab is much thinner than their boxes, which parts of smooth surfaces have: they separate more than boxes
// do, and nothing that shares a point.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "ecods/intersection.hpp"
#include "scenes/random.hpp"
#include "unit/bvh/separated_bodies.hpp"

namespace ecods::thin_slabs_test {
namespace {

// A strip of z = -curvature (x^2 + y^2) / 2, long in x, of 1024 triangles.
std::shared_ptr<const Mesh> strip(double curvature) {
    constexpr std::uint32_t length = 64, width = 8;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i <= length; ++i) {
        for (std::uint32_t k = 0; k <= width; ++k) {
            const double x = i / 32.0 - 1, y = k / 32.0 - 0.125;
            vertices.emplace_back(x, y, -curvature * (x * x + y * y) / 2);
            const std::uint32_t at = i * (width + 1) + k, next = at + width + 1;
            if (i == length || k == width) continue;
            triangles.push_back({at, next, next + 1});
            triangles.push_back({at, next + 1, at + 1});
        }
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

// Two strips, each turned at random, whose slopes face each other, in contact as thin as can be.
struct Strips {
    Body a, b;
    Vec3 up;  // moved along which the second leaves the first

    Strips(const std::shared_ptr<const Mesh>& mesh, scenes::Random& random) : a(mesh, Pose()), b(mesh, Pose()) {
        const auto slope = [&] { return random.uniform(0.4, 0.8) * (random.below(2) == 0 ? 1 : -1); };
        const double x_a = slope(), x_b = slope();
        const auto point = [](double x) { return Vec3(x, 0, -x * x / 2); };
        const auto normal = [](double x) { return Vec3(x, 0, 1).normalized(); };
        a.pose.R = random.rotation().toRotationMatrix();
        up = a.pose.R * normal(x_a);
        b.pose.R = Eigen::AngleAxisd(random.uniform(0, 6), up).toRotationMatrix() *
                   Eigen::Quaterniond::FromTwoVectors(normal(x_b), -up).toRotationMatrix();
        const Vec3 start = a.pose.R * point(x_a) - b.pose.R * point(x_b) - 0.01 * up;
        const MeshShape shape(mesh);
        QueryMemory memory;
        double touching = 0, apart = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * touching + 0.5 * apart;
            b.pose.t = start + middle * up;
            (intersects({shape, a.pose}, {shape, b.pose}, memory) ? touching : apart) = middle;
        }
        b.pose.t = start + touching * up;
    }
};

// Pairs of lanes of all nodes of a and all nodes and leaves of b that may overlap.
std::size_t near_count(const Strips& strips) {
    SeparatingAxes axes;
    if (axes.bind({strips.a.tree, strips.a.pose.R}, {strips.b.tree, strips.b.pose.R},
                  strips.b.pose.t - strips.a.pose.t) >= 0)
        return 0;
    int count = 0;
    for (const BvhNode& x : strips.a.tree.nodes) {
        for (const BvhNode& y : strips.b.tree.nodes) count += std::popcount(near_lanes_of_all(axes.sets(), x, y));
        for (const TreeLeaf& y : strips.b.tree.leaves) count += std::popcount(near_lanes_of_all(axes.sets(), x, y));
    }
    for (const TreeLeaf& x : strips.a.tree.leaves) {
        for (const BvhNode& y : strips.b.tree.nodes) count += std::popcount(near_lanes_of_all(axes.sets(), x, y));
    }
    return static_cast<std::size_t>(count);
}

void forget_thin_slabs(MeshBvh& tree) {
    for (BvhNode& node : tree.nodes) node.is_thin = false;
}

TEST(ThinSlabs, NeverSeparateStripsInContact) {
    scenes::Random random(41);
    const auto mesh = strip(1);
    for (int i = 0; i < 12; ++i) {
        const Strips strips(mesh, random);
        const std::vector<TrianglePair> pairs = pairs_of(strips.a, strips.b);
        ASSERT_FALSE(pairs.empty());
        for (const TrianglePair& pair : pairs) {
            ASSERT_TRUE(let_through_in_every_rounding_mode(strips.a, strips.b, pair.a, pair.b)) << i;
        }
    }
}

TEST(ThinSlabs, SeparateWhatBoxesDoNot) {
    scenes::Random random(42);
    const auto mesh = strip(1);
    EXPECT_TRUE(std::ranges::any_of(build(*mesh).nodes, &BvhNode::is_thin));
    std::size_t with = 0, without = 0;
    for (int i = 0; i < 8; ++i) {
        Strips strips(mesh, random);
        strips.b.pose.t += 0x1p-8 * strips.up;
        with += near_count(strips);
        forget_thin_slabs(strips.a.tree);
        forget_thin_slabs(strips.b.tree);
        without += near_count(strips);
    }
    EXPECT_LT(10 * with, 9 * without);
}

// Boxes are as thin as the slabs of what lies along them.
TEST(ThinSlabs, AreNoneInOnePlane) {
    const MeshBvh tree = build(*strip(0));
    EXPECT_FALSE(tree.nodes.empty());
    EXPECT_TRUE(std::ranges::none_of(tree.nodes, &BvhNode::is_thin));
}

}  // namespace
}  // namespace ecods::thin_slabs_test
