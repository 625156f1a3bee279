#include "suites/predicate_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ecods/primitives.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::bench {
namespace {

using scenes::Random;

std::shared_ptr<const Mesh> box(const Vec3& half, const Vec3& center = Vec3::Zero()) {
    return scenes::mapped(*scenes::cube(1), [&](const Vec3& v) -> Vec3 { return v.cwiseProduct(half) + center; });
}

// A number with a full mantissa, cut to `bits` bits after the point.
double number(Random& random, double min, double max, int bits) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    const double unit = std::ldexp(1.0, -bits);
    return std::floor((min + (max - min) * (x + y * 0x1p-32)) / unit) * unit;
}

Mat3 signed_permutation(Random& random) {
    Mat3 R = Mat3::Zero();
    const int shift = static_cast<int>(random.below(3));
    const bool mirrored = random.below(2) == 0;
    for (int i = 0; i < 3; ++i) R(i, (shift + (mirrored ? 2 - i : i)) % 3) = random.below(2) == 0 ? 1 : -1;
    return R;
}

Aabb triangle_box(const PredicateBody& body, std::size_t triangle) {
    std::vector<Vec3> corners;
    for (const std::uint32_t index : body.mesh->triangles()[triangle]) corners.push_back(body.mesh->vertices()[index]);
    return box_of(*Mesh::create(corners, {{0, 1, 2}}), body.pose);
}

// All pairs of bodies with overlapping boxes, and of their triangles.
void find_tasks(PredicateScene& scene) {
    std::vector<Aabb> boxes;
    std::vector<std::vector<Aabb>> triangle_boxes;
    for (const PredicateBody& body : scene.bodies) {
        boxes.push_back(box_of(*body.mesh, body.pose));
        auto& own = triangle_boxes.emplace_back();
        for (std::size_t i = 0; i < body.mesh->triangles().size(); ++i) own.push_back(triangle_box(body, i));
    }
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            if (!overlap(boxes[a], boxes[b])) continue;
            PredicateTask task{a, b, {}};
            for (std::uint32_t i = 0; i < triangle_boxes[a].size(); ++i) {
                for (std::uint32_t j = 0; j < triangle_boxes[b].size(); ++j) {
                    if (overlap(triangle_boxes[a][i], triangle_boxes[b][j])) task.pairs.push_back({i, j});
                }
            }
            if (!task.pairs.empty()) scene.tasks.push_back(std::move(task));
        }
    }
}

PredicateScene generic_boxes(std::size_t count) {
    PredicateScene scene{"generic boxes", 1.05, 1.00, {}, {}};
    Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
        Pose pose = random.turned();
        for (int k = 0; k < 3; ++k) pose.t[k] = number(random, -4, 4, 50);
        const Vec3 half{number(random, 0.3, 1, 50), number(random, 0.3, 1, 50), number(random, 0.3, 1, 50)};
        scene.bodies.push_back({box(half), pose});
    }
    return scene;
}

PredicateScene generic_spheres(std::size_t count) {
    PredicateScene scene{"generic spheres", 1.05, 1.00, {}, {}};
    Random random(2);
    const auto sphere = scenes::sphere(12, 8);
    for (std::size_t i = 0; i < count; ++i) {
        Pose pose = random.turned();
        for (int k = 0; k < 3; ++k) pose.t[k] = number(random, -4, 4, 50);
        scene.bodies.push_back({sphere, pose});
    }
    return scene;
}

PredicateScene brick_wall(std::size_t count) {
    PredicateScene scene{"axis-aligned dyadic brick wall", 1.2, 1.05, {}, {}};
    const auto brick = box(Vec3(0.5, 0.5, 0.25));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t row = i / 6;
        Pose pose;
        pose.t = Vec3(double(i % 6) + (row % 2 == 0 ? 0 : 0.5), double(row % 8), double(row / 8) * 0.5);
        scene.bodies.push_back({brick, pose});
    }
    return scene;
}

PredicateScene common_pose(std::size_t count) {
    PredicateScene scene{"touching cubes in one rotated pose", 3.5, 2, {}, {}};
    Random random(4);
    const double half = std::floor(0.1 * 0x1p44) * 0x1p-44;
    Pose pose = random.turned();
    for (int k = 0; k < 3; ++k) pose.t[k] = number(random, -10, 10, 48);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 center = 2 * half * Vec3(double(i % 5), double(i / 5 % 5), double(i / 25));
        scene.bodies.push_back({box(Vec3::Constant(half), center), pose});
    }
    return scene;
}

PredicateScene permuted_grid(std::size_t count) {
    PredicateScene scene{"45-bit cube grid, permutation matrices", 5, 2.5, {}, {}};
    Random random(5);
    const double half = std::floor(0.1 * 0x1p45) * 0x1p-45;
    const auto cube = box(Vec3::Constant(half));
    for (std::size_t i = 0; i < count; ++i) {
        Pose pose;
        pose.R = signed_permutation(random);
        pose.t = 2 * half * Vec3(double(i % 5), double(i / 5 % 5), double(i / 25));
        scene.bodies.push_back({cube, pose});
    }
    return scene;
}

// Boxes between planes at random numbers of 44 bits: their coordinates have no common length, as those of the cube grid
// do.
PredicateScene unequal_grid(std::size_t count) {
    PredicateScene scene{"45-bit unequal box grid, permutation matrices", 5, 2.5, {}, {}};
    Random random(7);
    std::array<std::vector<double>, 3> planes;
    for (auto& axis : planes) {
        axis.push_back(0);
        for (std::size_t i = 0; i <= count / 25 + 5; ++i) axis.push_back(axis.back() + number(random, 0.1, 0.3, 44));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<std::size_t, 3> cell{i % 5, i / 5 % 5, i / 25};
        Vec3 half;
        Pose pose;
        pose.R = signed_permutation(random);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            const double low = planes[k][cell[k]], high = planes[k][cell[k] + 1];
            half[at] = (high - low) / 2;
            pose.t[at] = (high + low) / 2;
        }
        scene.bodies.push_back({box(pose.R.transpose().cwiseAbs() * half), pose});
    }
    return scene;
}

// Touching boxes with full mantissas in one full matrix; translations that differ in a digit of no weight keep the
// poses from being equal: body b is modelled relative to a point of its own, moved there by R p exactly when p is zero.
PredicateScene full_matrices(std::size_t count) {
    PredicateScene scene{"full 53-bit matrices, no shortcut", 7.5, 4, {}, {}};
    PredicateScene source = common_pose(count);
    Random random(6);
    const Mat3 R = random.rotation().toRotationMatrix();
    for (std::size_t i = 0; i < count; ++i) {
        Pose pose;
        pose.R = R;
        // A power of two times R, and the mesh divided by it: the same points from other bits.
        const double scale = std::ldexp(1.0, static_cast<int>(i % 5));
        pose.R *= scale;
        std::vector<Vec3> vertices(source.bodies[i].mesh->vertices().begin(), source.bodies[i].mesh->vertices().end());
        for (Vec3& v : vertices) v /= scale;
        const auto triangles = source.bodies[i].mesh->triangles();  // the mesh lives on in `source`
        scene.bodies.push_back({Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()}), pose});
    }
    return scene;
}

}  // namespace

std::vector<PredicateScene> predicate_scenes(std::size_t body_count) {
    std::vector<PredicateScene> scenes{
        generic_boxes(body_count), generic_spheres(body_count / 4), brick_wall(body_count),   common_pose(body_count),
        permuted_grid(body_count), unequal_grid(body_count),        full_matrices(body_count)};
    for (PredicateScene& scene : scenes) find_tasks(scene);
    return scenes;
}

}  // namespace ecods::bench
