// Rays along axes, and points, against the boxes of posed trees: nothing that they meet is left out.
#include "bvh/masks/ray_mask.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "bvh/walks/tree_view.hpp"
#include "environment/instruction_sets.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::ray_mask_test {
namespace {

// The triangles that a walk comes to: the same for every instruction set.
std::set<std::uint32_t> visited(const TreeRay& ray, const MeshBvh& tree) {
    const auto walk = [&] {
        std::set<std::uint32_t> found;
        std::vector<TreeRef> stack;
        walk_triangles(
            tree, stack, [&](const auto& node) { return ray_mask(ray, node); },
            [&](std::uint32_t triangle) {
                EXPECT_TRUE(found.insert(triangle).second);
                return true;
            });
        return found;
    };
    const std::set<std::uint32_t> found = walk();
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limited(set);
        EXPECT_EQ(walk(), found) << environment::name(set);
    }
    return found;
}

std::vector<Mat3> matrices(scenes::Random& random) {
    std::vector<Mat3> all{Mat3::Identity()};
    for (int i = 0; i < 4; ++i) all.push_back(random.rotation().toRotationMatrix());
    all[2] *= 0x1p-300;
    all[3] *= 0x1p+300;
    all[4].col(1) *= 0x1p-30;
    Mat3 sheared = all[1];
    sheared(0, 1) += 7;
    all.push_back(sheared);
    return all;
}

// An error that a computed R v has, and adding to it: three products and sums, and one more.
double error_of(const Mat3& R, const Vec3& v, double added) {
    return 8 * 0x1p-52 * ((R.cwiseAbs() * v.cwiseAbs()).maxCoeff() + std::abs(added)) + 0x1p-1060;
}

TEST(RayMask, FindsTheTrianglesOfAVertexAheadAndAtIt) {
    scenes::Random random(3);
    std::size_t ahead = 0, left_out = 0;
    for (const auto& mesh : {scenes::sphere(20, 12), scenes::torus(16, 12, 0.25), scenes::cube(0.75)}) {
        const MeshBvh tree = build_mesh_bvh(*mesh, fit_frame(*mesh));
        for (const Mat3& R : matrices(random)) {
            const double size = R.cwiseAbs().maxCoeff();
            for (int i = 0; i < 60; ++i) {
                const auto triangle = random.below(static_cast<std::uint32_t>(mesh->triangles().size()));
                const Vec3& v = mesh->vertices()[mesh->triangles()[triangle][0]];
                const auto axis = static_cast<int>(random.below(3));
                const int sign = random.below(2) == 0 ? 1 : -1;
                const double back = i % 3 == 0 ? 0 : size * random.uniform(0, 1);
                Vec3 offset = R * v;
                TreeRay ray;
                ASSERT_TRUE(set_point(ray, tree, R, {offset, error_of(R, v, 0)}));
                ASSERT_TRUE(visited(ray, tree).contains(triangle));
                offset[axis] -= sign * back;
                const bool may_meet = set_ray(ray, tree, R, {offset, error_of(R, v, back)}, 1u << axis);
                ASSERT_TRUE(may_meet || back > 0);
                if (!may_meet) continue;
                ASSERT_EQ(ray.axis, axis);
                if (back > 0 && ray.sign != sign) continue;
                const auto found = visited(ray, tree);
                ASSERT_TRUE(found.contains(triangle));
                ++ahead;
                left_out += mesh->triangles().size() - found.size();
            }
        }
    }
    EXPECT_GT(ahead, 500u);
    EXPECT_GT(left_out, ahead * 100);
}

TEST(RayMask, NothingIsFoundFromOutsideTheBox) {
    const auto mesh = scenes::sphere(20, 12);
    const MeshBvh tree = build_mesh_bvh(*mesh, fit_frame(*mesh));
    TreeRay ray;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 offset = Vec3::Zero();
        offset[axis] = 1.25;
        EXPECT_FALSE(set_ray(ray, tree, Mat3::Identity(), {offset, 0}, 7));
        EXPECT_FALSE(set_point(ray, tree, Mat3::Identity(), {offset, 0}));
        EXPECT_TRUE(set_ray(ray, tree, Mat3::Identity(), {offset, 0.5}, 7)) << "where it may be inside";
    }
}

}  // namespace
}  // namespace ecods::ray_mask_test
