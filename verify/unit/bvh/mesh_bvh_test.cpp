// Trees contain what they stand for: exactly, by rational arithmetic.

#include "bvh/tree/mesh_bvh.hpp"

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "bvh/tree/frame_box.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "unit/bvh/tree_body.hpp"

namespace ecods::mesh_bvh_test {
namespace {

using Number = CGAL::Gmpq;
using ExactVec = std::array<Number, 3>;

// The y with center + map y = v, by Cramer's rule.
class ExactFrame {
  public:
    explicit ExactFrame(const LocalFrame& frame) : frame_(frame), determinant_(determinant(columns())) {}

    ExactVec coordinates(const Vec3& v) const {
        ExactVec y;
        for (int k = 0; k < 3; ++k) {
            auto c = columns();
            for (int row = 0; row < 3; ++row) c[k][row] = Number(v[row]) - Number(frame_.center[row]);
            y[k] = determinant(c) / determinant_;
        }
        return y;
    }

  private:
    using Columns = std::array<ExactVec, 3>;

    Columns columns() const {
        Columns c;
        for (int i = 0; i < 3; ++i) {
            for (int row = 0; row < 3; ++row) c[i][row] = Number(frame_.map(row, i));
        }
        return c;
    }
    static Number determinant(const Columns& c) {
        return c[0][0] * (c[1][1] * c[2][2] - c[2][1] * c[1][2]) - c[1][0] * (c[0][1] * c[2][2] - c[2][1] * c[0][2]) +
               c[2][0] * (c[0][1] * c[1][2] - c[1][1] * c[0][2]);
    }

    const LocalFrame& frame_;
    Number determinant_;
};

struct Ancestor {
    const BvhNode* node;
    std::size_t lane;
};

void expect_in_slab(const Slab& slab, const ExactVec& y) {
    Number sum = 0;
    for (int k = 0; k < 3; ++k) sum += Number(slab.normal[k]) * y[k];
    EXPECT_LE(Number(slab.low), sum);
    EXPECT_GE(Number(slab.high), sum);
}

struct Root {
    std::array<float, 3> center, half;
};

void expect_leaf_is_sound(const TreeLeaf& leaf, const Mesh& mesh, const ExactFrame& frame, const Root& root,
                          const std::vector<Ancestor>& above, std::vector<int>& seen) {
    ASSERT_GE(leaf.count, 1u);
    ASSERT_LE(leaf.count, tree_width);
    for (std::size_t lane = 0; lane < tree_width; ++lane) {
        const std::uint32_t triangle = leaf.triangle[lane];
        if (lane < leaf.count)
            ++seen[triangle];
        else
            EXPECT_EQ(triangle, leaf.triangle[leaf.count - 1]);
        for (int corner = 0; corner < 3; ++corner) {
            const ExactVec y = frame.coordinates(mesh.vertices()[mesh.triangles()[triangle][corner]]);
            for (int k = 0; k < 3; ++k) {
                ASSERT_LE(CGAL::abs(y[k]), 1);
                ASSERT_LE(CGAL::abs(y[k] - Number(root.center[k])), Number(root.half[k]));
                EXPECT_LE(CGAL::abs(y[k] - Number(leaf.corner[corner][k][lane])), Number(corner_error));
                for (const Ancestor& a : above) {
                    ASSERT_LE(CGAL::abs(y[k] - Number(a.node->center[k][a.lane])), Number(a.node->half[k][a.lane]));
                }
            }
            expect_in_slab(leaf.slab, y);
            for (const Ancestor& a : above) expect_in_slab(a.node->slab, y);
        }
    }
}

// Every triangle is below one leaf, in its slab, and in all boxes and slabs above, that of the root included.
void expect_sound(const MeshBvh& tree, const Mesh& mesh) {
    ASSERT_TRUE(tree.frame.is_bounded);
    const ExactFrame frame(tree.frame);
    std::vector<int> seen(mesh.triangles().size());
    std::vector<std::pair<TreeRef, std::vector<Ancestor>>> open{{tree.root, {}}};
    while (!open.empty()) {
        const auto [ref, above] = open.back();
        open.pop_back();
        if (ref.is_leaf()) {
            expect_leaf_is_sound(tree.leaves[ref.index()], mesh, frame, {tree.root_center, tree.root_half}, above,
                                 seen);
            continue;
        }
        const BvhNode& node = tree.nodes[ref.index()];
        ASSERT_GE(node.count, 2u);
        ASSERT_LE(node.count, tree_width);
        for (std::size_t lane = 0; lane < node.count; ++lane) {
            auto below = above;
            below.push_back({&node, lane});
            open.emplace_back(node.child[lane], below);
        }
    }
    for (const int count : seen) ASSERT_EQ(count, 1);
}

void expect_sound(const Mesh& mesh) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const MeshBvh tree = build(mesh);
        std::fesetround(FE_TONEAREST);
        expect_sound(tree, mesh);
    }
}

TEST(MeshBvh, ContainsItsTriangles) {
    expect_sound(*scenes::cube(0.5));
    expect_sound(*scenes::ship());
    expect_sound(*scenes::torus(14, 8, 0.25));
}

TEST(MeshBvh, ContainsDegenerateMeshes) {
    expect_sound(*Mesh::create({{1, 1, 1}}, {{0, 0, 0}}));
    expect_sound(*Mesh::create({{1, 1, 1}}, std::vector<Triangle>(100, Triangle{0, 0, 0})));
    expect_sound(*Mesh::create({{0, 0, 0}, {0x1p-1074, 0, 0}}, {{0, 1, 1}}));
    expect_sound(*Mesh::create({{1e250, 0, 0}, {1e250, 1, 1e-300}, {-3, 1, 0}}, {{0, 1, 2}, {2, 2, 1}}));
    expect_sound(*scenes::mapped(*scenes::ship(), [](const Vec3& v) { return Vec3(v[0], 0, 0); }));
}

TEST(MeshBvh, ContainsScaledAndFarMeshes) {
    for (const double scale : {0x1p-600, 1e-9, 1e9, 0x1p600}) {
        expect_sound(*scenes::mapped(*scenes::torus(8, 6, 0.25), [&](const Vec3& v) -> Vec3 { return scale * v; }));
    }
    expect_sound(
        *scenes::mapped(*scenes::torus(8, 6, 0.25), [](const Vec3& v) -> Vec3 { return v + Vec3(1e9, 0.1, -1e6); }));
}

// Coordinates as computed are off by less than what rounding to floats mostly covers: not where they are floats.
TEST(MeshBvh, BoxesOfTrianglesCoverTheErrorOfCoordinates) {
    scenes::Random random(17);
    const Mat3 turn = random.rotation().toRotationMatrix();
    const auto rod = scenes::mapped(*scenes::torus(10, 6, 0.25),
                                    [&](const Vec3& v) -> Vec3 { return turn * Vec3(10 * v[0], v[1], 0.5 * v[2]); });
    const LocalFrame frame = fit_frame(*rod);
    ASSERT_FALSE(frame.axes.isIdentity());
    const ExactFrame exact(frame);
    std::array<int, 2> below_and_above{};
    for (int i = 0; i < 4000; ++i) {
        Vec3 y;
        for (double& x : y) x = static_cast<double>(static_cast<float>(random.uniform(-0.9, 0.9)));
        const Vec3 v = frame.center + frame.map * y;
        const Vec3 computed = frame.coordinates(v);
        const ExactVec point = exact.coordinates(v);
        const FrameBox box = box_of(*Mesh::create({v}, {{0, 0, 0}}), {0, 0, 0}, frame);
        for (int k = 0; k < 3; ++k) {
            ASSERT_LE(Number(box.min[k]), point[k]);
            ASSERT_GE(Number(box.max[k]), point[k]);
            if (computed[k] == y[k]) ++below_and_above[point[k] > Number(y[k])];
        }
    }
    EXPECT_GT(std::min(below_and_above[0], below_and_above[1]), 100);
}

TEST(MeshBvh, TakesPrincipalAxesWhereTheyAreBetter) {
    scenes::Random random(3);
    for (int i = 0; i < 3; ++i) {
        const Mat3 turn = random.rotation().toRotationMatrix();
        const auto rod = scenes::mapped(*scenes::torus(10, 6, 0.25), [&](const Vec3& v) -> Vec3 {
            return turn * Vec3(10 * v[0], v[1], 0.5 * v[2]) + Vec3(3, 4, 5);
        });
        expect_sound(*rod);
        const LocalFrame frame = build(*rod).frame;
        EXPECT_FALSE(frame.axes.isIdentity());
        EXPECT_NEAR(std::abs((frame.axes.transpose() * turn.col(0)).cwiseAbs().maxCoeff()), 1, 1e-3);
    }
    EXPECT_TRUE(build(*scenes::cube(1)).frame.axes.isIdentity());
}

TEST(MeshBvh, HasNoFrameWhereCoordinatesAreHuge) {
    const MeshBvh tree = build(*Mesh::create({{1e308, 0, 0}, {-1e308, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}));
    EXPECT_FALSE(tree.frame.is_bounded);
}

TEST(MeshBvh, EqualAndCollinearTrianglesMakeAShallowTree) {
    const auto mesh = Mesh::create({{1, 1, 1}, {2, 1, 1}}, std::vector<Triangle>(5000, Triangle{0, 1, 1}));
    const MeshBvh tree = build(*mesh);
    EXPECT_LE(tree.leaves.size(), 5000u / 4);
    EXPECT_LE(tree.nodes.size(), tree.leaves.size());
}

// Twelve bytes for a triangle, times what leaves have free, are the vertices' names.
TEST(MeshBvh, IsCompact) {
    const auto torus = scenes::torus(100, 50, 0.4);
    const MeshBvh tree = build(*torus);
    EXPECT_LE(static_cast<double>(tree.bytes()), 72.0 * static_cast<double>(torus->triangles().size()));
}

TEST(MeshBvh, RefitContainsTheNewTriangles) {
    const auto torus = scenes::torus(14, 8, 0.25);
    const MeshBvh tree = build(*torus);
    scenes::Random random(8);
    const auto bent = scenes::mapped(
        *torus, [&](const Vec3& v) -> Vec3 { return v + Vec3(0.1 * v[1] * v[1], random.uniform(-0.01, 0.01), 7); });
    const MeshBvh refitted = refit_mesh_bvh(tree, *bent);
    expect_sound(refitted, *bent);
    EXPECT_EQ(refitted.leaves[0].triangle, tree.leaves[0].triangle) << "a small change keeps the tree";

    const auto flat = scenes::mapped(*torus, [](const Vec3& v) -> Vec3 {
        return {v[1], v[0], 0.9 * v[2] + 0.3 * v[0]};
    });
    const MeshBvh turned = refit_mesh_bvh(tree, *flat);
    expect_sound(turned, *flat);
    EXPECT_EQ(turned.leaves[0].triangle, tree.leaves[0].triangle);

    const auto shuffled = scenes::mapped(*torus, [&](const Vec3&) -> Vec3 {
        return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    });
    const MeshBvh rebuilt = refit_mesh_bvh(tree, *shuffled);
    expect_sound(rebuilt, *shuffled);
    EXPECT_DOUBLE_EQ(rebuilt.built_cost, build(*shuffled).built_cost) << "a large one makes a new tree";
}

}  // namespace
}  // namespace ecods::mesh_bvh_test
