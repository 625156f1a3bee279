// Which bodies of a scene collide, while they move?
#pragma once

#include "ecods/broad_phase.hpp"
#include "engines/engine.hpp"
#include "engines/frame_engine.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

// The bodies at rest are taken in untimed.
struct Scenes {
    using Workload = scenes::Scene;
    using Engine = FrameEngine<scenes::Move, IndexPair>;
    struct Traits {};
};

using SceneEngine = Scenes::Engine;
using SceneMaker = Maker<Scenes>;

std::unique_ptr<SceneEngine> set_up_world(const scenes::Scene& scene, BroadPhaseKind kind);  // ecods::World

std::vector<SceneMaker> ecods_worlds();     // once for each broad phase
std::vector<SceneMaker> ecods_all_pairs();  // ecods::intersects for every pair
std::vector<SceneMaker> fcl_scenes();       // DynamicAABBTree manager, OBBRSS meshes; and every pair without a manager

// All of the above.
std::vector<SceneMaker> scene_engines();

// Without all pairs of ECoDS, which are too many for many ships.
std::vector<SceneMaker> system_engines();
constexpr const char* scene_yardstick = "FCL, DynamicAABBTree";
constexpr const char* scene_fcl_all_pairs = "FCL, all pairs";

}  // namespace ecods::bench
