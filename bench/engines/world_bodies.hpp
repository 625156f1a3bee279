// Bodies of an ECoDS world by their indices in a scene.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "ecods/world.hpp"
#include "engines/frame_engine.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

class WorldBodies {
  public:
    explicit WorldBodies(const WorldOptions& options = {}) : world(options) {}
    explicit WorldBodies(const scenes::Scene& scene, const WorldOptions& options = {}) : world(options) {
        for (const scenes::SceneBody& body : scene.bodies) add(scene.meshes[body.mesh_index].mesh, body.pose);
    }

    template <class Thing>
    void add(const std::shared_ptr<const Thing>& mesh_or_shape, const Pose& pose) {
        ids_.push_back(world.create_body(mesh_or_shape, pose));
    }

    const std::vector<BodyId>& ids() const { return ids_; }
    BodyId operator[](std::size_t index) const { return ids_[index]; }
    std::size_t index_of(BodyId id) const {  // ids are given in ascending order
        return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
    }

    // Sets the poses in one call; putting the moves into its form is part of this.
    void move(std::span<const scenes::Move> moves) {
        moved_.clear();
        poses_.clear();
        for (const scenes::Move& move : moves) {
            moved_.push_back(ids_[move.body_index]);
            poses_.push_back(move.pose);
        }
        world.set_poses(moved_, poses_);
    }

    // The pairs that collide since the last update, ascending.
    std::vector<IndexPair> hits() const {
        std::vector<IndexPair> hits;
        for (const BodyPair& pair : world.colliding_pairs())
            hits.push_back(ordered(index_of(pair.a), index_of(pair.b)));
        std::sort(hits.begin(), hits.end());
        return hits;
    }

    World world;

  private:
    std::vector<BodyId> ids_;
    std::vector<BodyId> moved_;
    std::vector<Pose> poses_;
};

}  // namespace ecods::bench
