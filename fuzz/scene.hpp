// Two worlds that are told the same, and what they were told.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/ecods.hpp"
#include "fuzz/counters.hpp"
#include "oracle/oracle.hpp"

namespace ecods::fuzz {

struct Body {
    BodyId id;
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
    bool is_changed = true;                        // since the last frame that was checked
    std::optional<oracle::OracleMesh> exact = {};  // made when needed
};

// Every call goes to both worlds, which must answer alike.
class Scene {
  public:
    void create(const std::shared_ptr<const Mesh>& mesh, const Pose& pose);
    void destroy(std::size_t index);
    void set_pose(std::size_t index, const Pose& pose);
    void set_mesh(std::size_t index, const std::shared_ptr<const Mesh>& mesh);
    void update();

    std::array<World, 2> worlds = {World({.broad_phase = BroadPhaseKind::brute_force}),
                                   World({.broad_phase = BroadPhaseKind::sweep_and_prune})};
    std::vector<Body> bodies;  // in the order of creation
    std::vector<BodyId> dead;

    // What the oracle said, for all pairs of bodies at the last frame that was checked.
    std::map<BodyPair, oracle::Verdict> verdicts;
    std::vector<BodyPair> colliding;
};

}  // namespace ecods::fuzz
