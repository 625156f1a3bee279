// Bodies that share one point by construction, under poses that bring what prunes the search close to underflow: the
// answer is known without an oracle, and a box or plane that separates them is wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "ecods/intersection.hpp"
#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using scenes::Random;

Vec3 any_point(Random& random) {
    return {random.uniform(-1, 1) * random.uniform(0.5, 1), random.uniform(-1, 1) * random.uniform(0.5, 1),
            random.uniform(-1, 1) * random.uniform(0.5, 1)};
}

// A fan of triangles around the origin, all other corners on one side of a plane through it; most are up to 2^24 times
// smaller than the largest ones.
MeshShape any_fan(Random& random, double side) {
    const Vec3 normal(side, 2 * side, 3 * side);
    std::vector<Vec3> corners = {Vec3(0, 0, 0)};
    std::vector<Triangle> triangles;
    const std::uint32_t count = 3 + random.below(14), smallest = random.below(24);
    while (corners.size() <= count) {
        const Vec3 point = any_point(random);
        if (point.dot(normal) < 0.01) continue;
        corners.push_back(point *
                          std::ldexp(1.0, corners.size() < 3 ? 0 : -static_cast<int>(random.below(smallest + 1))));
    }
    for (std::uint32_t i = 1; i < count; ++i) triangles.push_back({0, i, i + 1});
    return MeshShape(Mesh::create(corners, triangles));
}

Mat3 any_matrix(Random& random) {
    Mat3 R;
    for (double& entry : R.reshaped()) entry = any_point(random)[0];
    return R;
}

// A pose under which both fans are; their common corner stays common.
void expect_contacts(Pose (*any_pose)(Random&)) {
    Random random(1);
    QueryMemory memory;
    for (int i = 0; i < 1000; ++i) {
        const MeshShape a = any_fan(random, 1), b = any_fan(random, -1);
        const Pose pose = any_pose(random);
        for (const InstructionSet set : environment::supported_instruction_sets()) {
            const environment::InstructionSetLimit limit(set);
            for (const environment::FloatMode& mode : environment::float_modes) {
                bool ab = false, ba = false;
                {
                    const environment::InFloatMode in_mode(mode);
                    ab = intersects({a, pose}, {b, pose}, memory);
                    ba = intersects({b, pose}, {a, pose}, memory);
                }
                ASSERT_TRUE(ab && ba) << "pair " << i << ", " << environment::name(set) << ", " << mode.name;
            }
        }
    }
}

// Determinants of corners lose parts to underflow, which find_near_planes adds a constant for.
TEST(ContactByConstruction, UnderPosesWithTwoTinyRows) {
    expect_contacts([](Random& random) {
        Pose pose{any_matrix(random), Vec3(0, 0, 0)};
        for (const int row : {1, 2}) pose.R.row(row) *= std::ldexp(1.0, -10 - static_cast<int>(random.below(110)));
        pose.R.row(0).swap(pose.R.row(random.below(3)));
        return pose;
    });
}

// Products of the matrix and a tree's axes lose digits to underflow, for which the margin is infinite beyond 2^900.
TEST(ContactByConstruction, UnderPosesThatShrinkToTheSmallestNumbers) {
    expect_contacts([](Random& random) {
        return Pose{any_matrix(random) * std::ldexp(1.0, -940 - static_cast<int>(random.below(130))), Vec3(0, 0, 0)};
    });
}

}  // namespace
}  // namespace ecods
