// The box of an support_table contains the exact body, and is not much larger than it need be.

#include "bounds/support_table.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <vector>

#include "environment/each_environment.hpp"
#include "oracle/oracle.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::support_table_test {
namespace {

std::shared_ptr<const Mesh> scaled(const Mesh& mesh, const Vec3& factor, const Vec3& shift) {
    return scenes::mapped(mesh, [&](const Vec3& v) -> Vec3 { return v.cwiseProduct(factor) + shift; });
}

struct Excess {
    double mean = 0;  // of the sides, over the half diagonal of the body
    double max = 0;
};

// Boxes of random affine poses: contain the body in every rounding mode.
Excess measure(const std::shared_ptr<const Mesh>& mesh, double shear) {
    const LocalFrame frame = fit_frame(*mesh);
    const SupportTable support_table(*mesh, frame);
    scenes::Random random(17);
    Excess excess;
    constexpr int pose_count = 150;
    for (int i = 0; i < pose_count; ++i) {
        Pose pose = random.turned();
        for (int k = 0; k < 9; ++k) pose.R.data()[k] += shear * random.uniform(-1, 1);
        for (int k = 0; k < 3; ++k) pose.t[k] = random.uniform(-1000, 1000);
        if (i == 0) pose.R.setZero();
        if (i == 1) pose.R = Mat3::Identity();
        const oracle::OracleMesh exact(mesh, pose);
        const Aabb tight = exact.outer_box();
        for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            const Aabb box = support_table.box(pose);
            std::fesetround(FE_TONEAREST);
            EXPECT_TRUE(oracle::box_contains(box, exact)) << i;
            const Vec3 outside = (tight.min - box.min).cwiseMax(box.max - tight.max);
            const double size = std::max(0.5 * (tight.max - tight.min).norm(), 0x1p-900);
            if (i == 0) continue;
            excess.mean += outside.mean() / size / (4 * (pose_count - 1));
            excess.max = std::max(excess.max, outside.maxCoeff() / size);
        }
    }
    return excess;
}

TEST(SupportTable, ContainsTheBodyAndIsTight) {
    for (const double shear : {0.0, 0.5}) {
        const Excess ship = measure(scenes::ship(), shear), sphere = measure(scenes::sphere(24, 12), shear),
                     torus = measure(scenes::torus(30, 20, 0.25), shear);
        EXPECT_LT(ship.mean, 0.03);
        EXPECT_LT(ship.max, 0.125);
        EXPECT_LT(sphere.mean, 0.01);
        EXPECT_LT(sphere.max, 0.02);
        EXPECT_LT(torus.mean, 0.01);
        EXPECT_LT(torus.max, 0.06);
    }
}

TEST(SupportTable, RodsAndPlatesAreTightByTheirOrientedBox) {
    const auto rod = scaled(*scenes::sphere(12, 8), Vec3(10, 0.01, 0.01), Vec3(1, 2, 3));
    EXPECT_LT(measure(rod, 0).max, 0.01);
    const auto plate = scaled(*scenes::sphere(12, 8), Vec3(10, 8, 0), Vec3(1, 2, 3));
    EXPECT_LT(measure(plate, 0).max, 0.125);
}

TEST(SupportTable, ContainsBodiesOfEverySize) {
    for (const double scale : {0x1p-1060, 0x1p-500, 1e-12, 1e12, 0x1p500}) {
        measure(scaled(*scenes::ship(), Vec3::Constant(scale), Vec3(0, 3 * scale, 0)), 0.1);
    }
    measure(scaled(*scenes::ship(), Vec3::Constant(1e-6), Vec3(1e6, 0, 1)), 0.1);
}

TEST(SupportTable, IsInfiniteOnlyBeyondTheLargestDouble) {
    const auto sphere = scenes::sphere(12, 8);
    const LocalFrame frame = fit_frame(*sphere);
    const SupportTable support_table(*sphere, frame);
    Pose pose;
    pose.R *= 1.7e308;
    EXPECT_LT(support_table.box(pose).max[0], 1.79e308);
    pose.t[0] = 1.7e308;
    EXPECT_EQ(support_table.box(pose).max[0], std::numeric_limits<double>::infinity());
    EXPECT_GT(support_table.box(pose).min[0], -1e307);
    EXPECT_GT(support_table.box(pose).min[1], -1.79e308);
}

// Rounding down makes large numbers of some infinities.
TEST(SupportTable, ContainsBodiesNearTheEndOfTheRange) {
    const auto sphere = scaled(*scenes::sphere(12, 8), Vec3::Constant(0x1p-40), Vec3::Zero());
    const auto few = scaled(*scenes::cube(1), Vec3(0x1p600, 0x1p600, 1), Vec3(0x1p1023, -0x1p1020, 0));
    const LocalFrame frame = fit_frame(*sphere);
    const SupportTable support_table(*sphere, frame);
    Pose turned;
    turned.R.setConstant(1.7e308);
    Pose stretched;
    stretched.R << 2.5, 1, 0, 0, 1, 0, 0, 0, 1;
    stretched.t = Vec3(-0x1.8p1023, 0, 0);
    const oracle::OracleMesh exact_sphere(sphere, turned), exact_few(few, stretched);
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const Aabb round_box = support_table.box(turned), few_box = box_of(*few, stretched);
        std::fesetround(FE_TONEAREST);
        EXPECT_TRUE(oracle::box_contains(round_box, exact_sphere)) << mode;
        EXPECT_TRUE(oracle::box_contains(few_box, exact_few)) << mode;
    }
}

// Poses at once, one to nineteen of them, give the bits that each gives alone: turned, sheared and flat ones, bodies
// that are tiny, far away or at the ends of the range, zeros of either sign, and one beyond the bound among others that
// are not.
TEST(SupportTable, PosesAtOnceGetTheBoxOfEach) {
    scenes::Random random(23);
    std::vector<Pose> poses;
    for (int i = 0; i < 400; ++i) {
        Pose& pose = poses.emplace_back(random.turned());
        for (int k = 0; k < 3; ++k) pose.t[k] = random.uniform(-10, 10);
        if (i % 5 == 1) pose.R.col(i % 3).setZero();
        if (i % 7 == 2) pose.R = -Mat3::Identity();
        if (i % 11 == 3) pose.R *= std::ldexp(1, static_cast<int>(random.below(2100)) - 1080);
        if (i % 13 == 4) pose.t *= std::ldexp(1, static_cast<int>(random.below(2000)) - 1000);
        if (i % 17 == 5) pose.t = Vec3(0, -0.0, 0x1p-1074);
        if (i % 29 == 6) pose.R.setConstant(1.7e308);
    }
    // A side at zero: a point whose distance from the origin is the bound of its error.
    for (int i = 0; i < 32; ++i) {
        Pose& pose = poses.emplace_back();
        pose.R.setZero();
        pose.t.setConstant(std::ldexp((i < 16 ? 1 : -1) * (1 + i % 16 * 0x1p-52), -1000));
    }
    const auto ship = scenes::ship();
    for (const auto& mesh : {scaled(*ship, Vec3::Ones(), Vec3(1, 2, 3)), scaled(*ship, Vec3(1, 1, 0), Vec3::Zero()),
                             scaled(*ship, Vec3::Constant(0x1p-1060), Vec3::Zero()),
                             scaled(*ship, Vec3::Constant(0x1p1000), Vec3::Zero())}) {
        const LocalFrame frame = fit_frame(*mesh);
        if (!frame.is_bounded) continue;
        const SupportTable support_table(*mesh, frame);
        const auto differing_pose = [&]() -> std::size_t {
            std::vector<Aabb> boxes(poses.size());
            std::vector<const Pose*> some_poses;
            std::vector<Aabb*> some_boxes;
            for (std::size_t i = 0, count = 1; i < poses.size(); ++i) {
                some_poses.push_back(&poses[i]);
                some_boxes.push_back(&boxes[i]);
                if (some_poses.size() < count && i + 1 < poses.size()) continue;
                support_table.boxes(some_poses, some_boxes);
                some_poses.clear();
                some_boxes.clear();
                count = count % 19 + 1;
            }
            for (std::size_t i = 0; i < poses.size(); ++i) {
                const Aabb box = support_table.box(poses[i]);
                if (std::memcmp(&box, &boxes[i], sizeof box) != 0) return i;
            }
            return poses.size();
        };
        environment::in_each_environment(differing_pose, [&](std::size_t differing, const std::string& where) {
            EXPECT_EQ(differing, poses.size()) << where;
        });
    }
}

// Vertices that no triangle uses do not belong to the mesh.
TEST(SupportTable, IsOfTheVerticesInUse) {
    const auto ship = scenes::ship();
    std::vector<Vec3> vertices(ship->vertices().begin(), ship->vertices().end());
    vertices.emplace_back(100, -200, 300);
    const auto more = Mesh::create(std::move(vertices), {ship->triangles().begin(), ship->triangles().end()});
    scenes::Random random(19);
    Pose pose = random.turned();
    pose.t = Vec3(1, 2, 3);
    const LocalFrame frame = fit_frame(*ship), frame_of_more = fit_frame(*more);
    EXPECT_EQ(SupportTable(*more, frame_of_more).box(pose), SupportTable(*ship, frame).box(pose));
}

}  // namespace
}  // namespace ecods::support_table_test
