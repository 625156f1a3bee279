// Poses and small assertions for the tests of World.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ecods/world.hpp"

namespace ecods {

inline Pose at(double x, double y = 0, double z = 0) {
    Pose pose;
    pose.t = Vec3(x, y, z);
    return pose;
}

inline std::vector<BodyPair> list(std::span<const BodyPair> pairs) {
    return {pairs.begin(), pairs.end()};
}

// What is true of a world does not depend on its broad phase: suites run with each.
inline auto broad_phases() {
    return testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                           BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic);
}

inline std::string broad_phase_name(const testing::TestParamInfo<BroadPhaseKind>& tested) {
    return "Kind" + std::to_string(static_cast<int>(tested.param));
}

}  // namespace ecods
