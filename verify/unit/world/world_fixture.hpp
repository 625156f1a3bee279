// Fixtures and small assertions for the tests of World.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {

inline std::vector<BodyPair> list(std::span<const BodyPair> pairs) {
    return {pairs.begin(), pairs.end()};
}

// Expects that the call names the question, and the kinds in the order in which a test was registered for them.
template <class Call>
void expect_not_supported(const Call& call, Question question, ShapeKind a, ShapeKind b) {
    try {
        call();
        ADD_FAILURE() << "not refused";
    } catch (const NotSupported& error) {
        EXPECT_EQ(error.question, question);
        EXPECT_EQ(error.a, a);
        EXPECT_EQ(error.b, b);
    }
}

// Ranks of hits that are in order: those of one parameter are first together. Where parameters are not rounded.
inline void rank_by_parameter(std::vector<BodyHit>& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i].hit.rank = i == 0 ? 0 : hits[i - 1].hit.rank + (hits[i].hit.parameter != hits[i - 1].hit.parameter);
    }
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
