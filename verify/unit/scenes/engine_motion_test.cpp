#include "scenes/engine_motion.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "scenes/io/gltf_file.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {
namespace {

class EngineMotion : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(engine_file())) GTEST_SKIP() << "assimp-testmodels is not installed";
        engine_ = read_gltf_file(engine_file());
        run_engine(engine_, 72);
    }

    const std::string& mesh_name(std::size_t body) const {
        return engine_.meshes[engine_.bodies[body].mesh_index].name;
    }

    Scene engine_;
};

TEST_F(EngineMotion, MovesTenPartsInEachFrame) {
    EXPECT_EQ(engine_.bodies.size(), 67u);
    ASSERT_EQ(engine_.frames.size(), 72u);
    for (const Frame& frame : engine_.frames) EXPECT_EQ(frame.moves.size(), 10u);
}

TEST_F(EngineMotion, TheFullCycleLeadsBackToTheRest) {
    for (const Move& move : engine_.frames.back().moves) {
        const Pose& rest = engine_.bodies[move.body_index].pose;
        EXPECT_LT((move.pose.R - rest.R).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((move.pose.t - rest.t).cwiseAbs().maxCoeff(), 1e-3);
    }
}

TEST_F(EngineMotion, PistonsTravelTwiceTheThrowAlongXOnly) {
    std::map<std::size_t, std::pair<double, double>> range;
    for (const Frame& frame : engine_.frames) {
        for (const Move& move : frame.moves) {
            if (mesh_name(move.body_index).find("Piston") == std::string::npos) continue;
            const Pose& rest = engine_.bodies[move.body_index].pose;
            EXPECT_EQ(move.pose.R, rest.R);
            EXPECT_EQ(move.pose.t.y(), rest.t.y());
            EXPECT_EQ(move.pose.t.z(), rest.t.z());
            auto& [min, max] = range.try_emplace(move.body_index, move.pose.t.x(), move.pose.t.x()).first->second;
            min = std::min(min, move.pose.t.x());
            max = std::max(max, move.pose.t.x());
        }
    }
    ASSERT_EQ(range.size(), 2u);
    for (const auto& [body, x] : range) EXPECT_NEAR(x.second - x.first, 72, 0.5);
}

// Where a move takes the point that is at `point` while the engine rests.
Vec3 follow(const Scene& scene, const Move& move, const Vec3& point) {
    const Pose& rest = scene.bodies[move.body_index].pose;
    return move.pose.R * (rest.R.transpose() * (point - rest.t)) + move.pose.t;
}

TEST_F(EngineMotion, RodsStayOnTheirPins) {
    struct Side {
        double sign;
        std::string rod, pin;
    };
    for (const Side& side : {Side{1, "rod_123-699_0_Parts_1 (node 74)", "body_24 (node 6)"},
                             Side{-1, "rod_123-699_0_Parts_1 (node 73)", "body_24 (node 3)"}}) {
        const Vec3 small_end(side.sign * 164.6863, 0, 0), big_end = side.sign * Vec3(27.61788, 23.09221, 0);
        for (const Frame& frame : engine_.frames) {
            Vec3 rod_small = Vec3::Zero(), rod_big = Vec3::Zero(), pin = Vec3::Zero();
            for (const Move& move : frame.moves) {
                const std::string& name = engine_.bodies[move.body_index].name;
                if (name == side.pin) pin = follow(engine_, move, small_end);
                if (name != side.rod) continue;
                rod_small = follow(engine_, move, small_end);
                rod_big = follow(engine_, move, big_end);
            }
            EXPECT_LT((rod_small - pin).cwiseAbs().maxCoeff(), 1e-3);
            EXPECT_NEAR(rod_big.norm(), 36, 1e-3);
        }
    }
}

TEST(EngineMotionErrors, AMissingPartIsNamed) {
    Scene scene;
    scene.meshes.push_back({"cube", cube(1)});
    scene.bodies.push_back({"cube", 0, {}});
    try {
        run_engine(scene, 1);
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("body_22"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace ecods::scenes
