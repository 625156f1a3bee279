// ECoDS as it is meant to be used: a World.
#include <algorithm>
#include <map>

#include "ecods/world.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

namespace {

class EcodsWorld final : public Engine {
  public:
    EcodsWorld(const scenes::Scene& scene, BroadPhaseKind kind) : world_({.broad_phase = kind}) {
        for (const scenes::SceneBody& body : scene.bodies) {
            const BodyId id = world_.create_body(scene.meshes[body.mesh_index].mesh, body.pose);
            index_of_[id] = ids_.size();
            ids_.push_back(id);
        }
    }

    void run_frame(std::span<const scenes::Move> moves) override {
        moved_.clear();
        poses_.clear();
        for (const scenes::Move& move : moves) {
            moved_.push_back(ids_[move.body_index]);
            poses_.push_back(move.pose);
        }
        world_.set_poses(moved_, poses_);
        world_.update();
    }

    std::vector<IndexPair> hits() const override {
        std::vector<IndexPair> hits;
        for (const BodyPair& pair : world_.colliding_pairs())
            hits.push_back(ordered(index_of_.at(pair.a), index_of_.at(pair.b)));
        std::sort(hits.begin(), hits.end());
        return hits;
    }

    std::size_t candidate_count() const override { return world_.statistics().overlapping_count; }
    std::optional<Statistics> statistics() const override { return world_.statistics(); }

  private:
    World world_;
    std::vector<BodyId> ids_;
    std::vector<BodyId> moved_;  // of a frame: putting its moves into the form of the call is timed, too
    std::vector<Pose> poses_;
    std::map<BodyId, std::size_t> index_of_;
};

}  // namespace

std::unique_ptr<Engine> set_up_world(const scenes::Scene& scene, BroadPhaseKind kind) {
    return std::make_unique<EcodsWorld>(scene, kind);
}

}  // namespace ecods::bench
