// Fixtures and small assertions for the tests of World.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {

inline std::vector<BodyPair> list(std::span<const BodyPair> pairs) {
    return {pairs.begin(), pairs.end()};
}

// What is true of a world does not depend on its broad phase: suites run with each.
inline auto broad_phases() {
    return testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                           BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic);
}

// A world with one of them.
class EachWorld : public testing::TestWithParam<BroadPhaseKind> {
  protected:
    World world{WorldOptions{GetParam()}};
    std::shared_ptr<const Mesh> cube = scenes::cube(0.5);
    QueryMemory memory;
};

inline std::string broad_phase_name(const testing::TestParamInfo<BroadPhaseKind>& tested) {
    return "Kind" + std::to_string(static_cast<int>(tested.param));
}

}  // namespace ecods
