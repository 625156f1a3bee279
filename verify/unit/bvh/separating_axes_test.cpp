// What shares a point is never separated, however hard it is tried; most of what is well apart is.

#include "bvh/separating_axes.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "ecods/predicates.hpp"
#include "environment/instruction_sets.hpp"
#include "oracle/oracle.hpp"
#include "scenes/flush_parts.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

MeshBvh build(const Mesh& mesh) {
    return build_mesh_bvh(mesh, fit_frame(mesh));
}

constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

struct Body {
    std::shared_ptr<const Mesh> mesh;
    MeshBvh tree;
    Pose pose;

    Body(std::shared_ptr<const Mesh> m, const Pose& p) : mesh(std::move(m)), tree(build(*mesh)), pose(p) {}
};

// overlap_mask(), once it is the same for every instruction set.
template <class X, class Y>
std::uint64_t near_lanes_of_all(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) {
    const std::uint64_t near = overlap_mask(sets, x, y);
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        EXPECT_EQ(overlap_mask(sets, x, y), near) << environment::name(set);
    }
    return near;
}

// Whether the trees let triangles i and j through, from the roots down.
bool let_through(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    SeparatingAxes axes;
    if (axes.bind({a.tree, a.pose.R}, {b.tree, b.pose.R}, b.pose.t - a.pose.t) >= 0) return false;
    const auto& sets = axes.sets();
    std::vector<std::pair<TreeRef, TreeRef>> open{{a.tree.root, b.tree.root}};
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        const auto visit = [&](std::uint64_t near, const auto& below_x, const auto& below_y) {
            for (std::size_t bit = 0; bit < 64; ++bit) {
                if (near >> bit & 1) open.emplace_back(below_x(bit % 8), below_y(bit / 8));
            }
        };
        const auto x_itself = [&](std::size_t) { return x; };
        const auto y_itself = [&](std::size_t) { return y; };
        const auto x_child = [&](std::size_t lane) { return a.tree.nodes[x.index()].child[lane]; };
        const auto y_child = [&](std::size_t lane) { return b.tree.nodes[y.index()].child[lane]; };
        if (x.is_leaf() && y.is_leaf()) {
            const TreeLeaf &p = a.tree.leaves[x.index()], &q = b.tree.leaves[y.index()];
            const std::uint64_t near = near_lanes_of_all(sets, p, q);
            for (std::size_t bit = 0; bit < 64; ++bit) {
                if (near >> bit & 1 && p.triangle[bit % 8] == i && q.triangle[bit / 8] == j) return true;
            }
        } else if (x.is_leaf()) {
            visit(near_lanes_of_all(sets, a.tree.leaves[x.index()], b.tree.nodes[y.index()]), x_itself, y_child);
        } else if (y.is_leaf()) {
            visit(near_lanes_of_all(sets, a.tree.nodes[x.index()], b.tree.leaves[y.index()]), x_child, y_itself);
        } else {
            visit(near_lanes_of_all(sets, a.tree.nodes[x.index()], b.tree.nodes[y.index()]), x_child, y_child);
        }
    }
    return false;
}

bool let_through_in_every_rounding_mode(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    bool all = true;
    for (const int mode : rounding_modes) {
        std::fesetround(mode);
        all = all && let_through(a, b, i, j) && let_through(b, a, j, i);
    }
    std::fesetround(FE_TONEAREST);
    return all;
}

TEST(SeparatingAxes, NeverSeparateTrianglesThatMeet) {
    scenes::Random random(5);
    std::uint64_t separated = 0, apart = 0;
    for (const scenes::HardFamily family : scenes::hard_families()) {
        for (int i = 0; i < 300; ++i) {
            const scenes::PosedPair pair = scenes::make_pair(family, random);
            const auto mesh_of = [](const std::array<Vec3, 3>& t) {
                return Mesh::create({t.begin(), t.end()}, {{0, 1, 2}});
            };
            const Body a(mesh_of(pair.a), pair.pose_a), b(mesh_of(pair.b), pair.pose_b);
            const bool meet = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::disjoint;
            if (meet) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, 0, 0)) << scenes::name(family) << " " << i;
            } else {
                ++apart;
                separated += !let_through(a, b, 0, 0);
            }
        }
    }
    EXPECT_GT(separated, apart / 2) << "the test would be sound if it separated nothing";
}

// The pairs of triangles that share a point, without a tree.
std::vector<TrianglePair> pairs_of(const Body& a, const Body& b) {
    std::vector<TrianglePair> pairs;
    for (std::uint32_t i = 0; i < a.mesh->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.mesh->triangles().size(); ++j) {
            const auto corners = [](const Body& body, std::uint32_t t) {
                const Triangle& indices = body.mesh->triangles()[t];
                const auto v = body.mesh->vertices();
                return std::array<Vec3, 3>{v[indices[0]], v[indices[1]], v[indices[2]]};
            };
            if (triangle_triangle({a.pose, corners(a, i)}, {b.pose, corners(b, j)}) != Relation::disjoint) {
                pairs.push_back({i, j});
            }
        }
    }
    return pairs;
}

// Moves b towards a along a line until the last double at which they still touch: a contact that is as thin as can be.
// The line begins at `start`, where they touch.
void bring_into_contact(const Body& a, Body& b, const Vec3& direction, const Vec3& start) {
    double touching = 0, apart = 8;
    for (int i = 0; i < 70; ++i) {
        const double middle = 0.5 * touching + 0.5 * apart;
        b.pose.t = start + middle * direction;
        (pairs_of(a, b).empty() ? apart : touching) = middle;
    }
    b.pose.t = start + touching * direction;
}
void bring_into_contact(const Body& a, Body& b, const Vec3& direction) {
    bring_into_contact(a, b, direction, a.pose.t);
}

// Boxes in contact under rotations that are off by more and more: rounding, shear, scale.
TEST(SeparatingAxes, NeverSeparateBoxesInContactUnderPerturbedMatrices) {
    scenes::Random random(11);
    for (const double error : {0.0, 1e-16, 1e-12, 1e-6, 1e-3, 0.3}) {
        for (int i = 0; i < 25; ++i) {
            const auto pose = [&] {
                Pose p;
                p.R = random.rotation().toRotationMatrix();
                for (int k = 0; k < 9; ++k) p.R.data()[k] += error * random.uniform(-1, 1);
                for (int k = 0; k < 3; ++k) p.t[k] = random.uniform(-10, 10);
                return p;
            };
            const Body a(scenes::cube(0.5), pose());
            Body b(scenes::cube(random.uniform(0.125, 1)), pose());
            bring_into_contact(a, b, Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1).normalized());
            const std::vector<TrianglePair> pairs = pairs_of(a, b);
            ASSERT_FALSE(pairs.empty());
            for (const TrianglePair& pair : pairs) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << error << " " << i;
            }
        }
    }
}

// The roots, in particular: boxes of which faces, edges or corners touch exactly.
TEST(SeparatingAxes, NeverSeparateRootsInExactContact) {
    const Body a(scenes::cube(0.5), Pose());
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                Pose pose;
                pose.t = Vec3(x, y, z);
                const Body b(scenes::cube(0.5), pose);
                for (const TrianglePair& pair : pairs_of(a, b)) {
                    ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b));
                }
            }
        }
    }
}

// Far from the origin of their own coordinates, boxes are placed by sums that cancel: rounding is then larger than what
// boxes are rounded outwards by, and only the bound saves what touches. Contact is exact, whatever the common pose.
TEST(SeparatingAxes, NeverSeparateRootsInContactFarFromTheirOwnOrigins) {
    scenes::Random random(31);
    for (int exponent = 8; exponent <= 44; exponent += 4) {
        for (int i = 0; i < 40; ++i) {
            Pose pose;
            pose.R = random.rotation().toRotationMatrix();
            if (i % 4 == 3) pose.R += 0.3 * Mat3::NullaryExpr([&] { return random.uniform(-1, 1); });
            const auto cube_at = [](const Vec3& offset) {
                const auto cube = scenes::cube(0.5);
                std::vector<Vec3> vertices(cube->vertices().begin(), cube->vertices().end());
                for (Vec3& v : vertices) v += offset;
                return Mesh::create(std::move(vertices), {cube->triangles().begin(), cube->triangles().end()});
            };
            Vec3 place, step;
            for (int k = 0; k < 3; ++k) {
                place[k] = std::floor(random.uniform(-1, 1) * std::ldexp(1, exponent));
                pose.t[k] = random.uniform(-10, 10);
                step[k] = static_cast<double>(random.below(3)) - 1;
            }
            if (step.isZero()) step[2] = 1;
            const Body a(cube_at(place), pose), b(cube_at(place + step), pose);
            const std::vector<TrianglePair> pairs = pairs_of(a, b);
            ASSERT_FALSE(pairs.empty());
            for (const TrianglePair& pair : pairs) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << exponent << " " << i;
            }
        }
    }
}

// A flat box under a pose with two nearly parallel columns and a short third: the box's own normals, as computed, undo
// such a pose less precisely than their size tells, and a flat box has nothing to spare. A tiny triangle goes through
// the large one, near a corner.
TEST(SeparatingAxes, NeverSeparateFlatBoxesUnderShearedPoses) {
    scenes::Random random(37);
    constexpr double r = 1 - 0x1p-10, tiny = 0x1p-49;
    const auto flat = Mesh::create({Vec3(-r, -r, 0), Vec3(r, r, 0), Vec3(-r, r, 0)}, {{0, 1, 2}});
    for (int i = 0; i < 1000; ++i) {
        const Mat3 Q = random.rotation().toRotationMatrix();
        Pose sheared, there;
        const double angle = std::exp2(random.uniform(-12, -9)), length = std::exp2(random.uniform(-1, 1));
        sheared.R.col(0) = Q.col(0);
        sheared.R.col(1) = length * (Q.col(0) + angle * Q.col(1));
        sheared.R.col(2) = std::exp2(random.uniform(-3, 0)) * Q.col(2);
        there.t = sheared.R * (i % 2 == 0 ? Vec3(0.998, 0.9985, 0) : Vec3(-0.9985, -0.998, 0));
        const auto through = Mesh::create({tiny * Q.col(2), -tiny * Q.col(2), tiny * Q.col(0)}, {{0, 1, 2}});
        ASSERT_TRUE(oracle::intersects({flat, sheared}, {through, there}));
        const Body a(flat, sheared), b(through, there);
        ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, 0, 0)) << i;
    }
}

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

// The mesh, flat at z = 0, so that it is flat across the axis.
std::shared_ptr<const Mesh> across(const Mesh& mesh, int axis) {
    std::vector<Vec3> vertices;
    for (const Vec3& v : mesh.vertices()) {
        Vec3 w;
        for (int k = 0; k < 3; ++k) w[(axis + 1 + k) % 3] = v[k];
        vertices.push_back(w);
    }
    return Mesh::create(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()});
}

// In one plane triangles are told apart by their edges, slivers above all: their edges are short beside the rest, and
// contacts here are as thin as doubles can say.
TEST(SeparatingAxes, NeverSeparateFlatBodiesInContact) {
    scenes::Random random(41);
    for (int i = 0; i < 60; ++i) {
        const int axis = i % 3;
        const double size = i % 5 == 0 ? 0x1p-40 : 1;
        const Body a(across(*polygon(5 + random.below(20), i % 2 == 0), axis), in_plane(random, axis, 1));
        Body b(across(*polygon(5 + random.below(20), i % 4 < 2), axis), in_plane(random, axis, size));
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
TEST(SeparatingAxes, NeverSeparateSmallTrianglesOfLargeFlatBodiesInContact) {
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
            return across(*Mesh::create(std::move(vertices), {{0, 1, 2}, {3, 4, 5}}), axis);
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
TEST(SeparatingAxes, SlabsOfFlatSliversLieAcrossThem) {
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
TEST(SeparatingAxes, SeparateSliversOfOnePlane) {
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

// Each kind of axis separates something that no axis before it does.
TEST(SeparatingAxes, AllFifteenAxesSeparateSomething) {
    scenes::Random random(21);
    std::array<int, 15> counts{};
    const auto cube = scenes::cube(0.5);
    const MeshBvh tree = build(*cube);
    for (int i = 0; i < 20000; ++i) {
        const Mat3 a = random.rotation().toRotationMatrix(), b = random.rotation().toRotationMatrix();
        SeparatingAxes axes;
        const int axis =
            axes.bind({tree, a}, {tree, b}, Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
        if (axis >= 0) ++counts[static_cast<std::size_t>(axis)];
    }
    for (const int count : counts) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace ecods
