// ECoDS as it is meant to be used, a World; and without its manager.
#include "ecods/intersection.hpp"
#include "engines/broad_phase_kinds.hpp"
#include "engines/scene_engine.hpp"
#include "engines/world_bodies.hpp"

namespace ecods::bench {

namespace {

class EcodsWorld final : public SceneEngine {
  public:
    EcodsWorld(const scenes::Scene& scene, BroadPhaseKind kind) : bodies_(scene, {.broad_phase = kind}) {}

    void run_frame(std::span<const scenes::Move> moves) override {
        bodies_.move(moves);
        bodies_.world.update();
    }

    std::vector<IndexPair> pairs() const override { return bodies_.hits(); }
    std::size_t candidate_count() const override { return bodies_.world.statistics().overlapping_count; }
    std::optional<Statistics> statistics() const override { return bodies_.world.statistics(); }

  private:
    WorldBodies bodies_;
};

// Every pair of bodies is given to the two-body query, every frame. The report calls this pair-wise testing.
class EcodsAllPairs final : public SceneEngine {
  public:
    explicit EcodsAllPairs(const scenes::Scene& scene) {
        for (const scenes::NamedMesh& named : scene.meshes) shapes_.push_back(std::make_unique<MeshShape>(named.mesh));
        for (const scenes::SceneBody& body : scene.bodies) bodies_.emplace_back(*shapes_[body.mesh_index], body.pose);
    }

    void run_frame(std::span<const scenes::Move> moves) override {
        for (const scenes::Move& move : moves) bodies_[move.body_index].pose = move.pose;
        hits_.clear();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            for (std::size_t k = i + 1; k < bodies_.size(); ++k) {
                if (intersects(bodies_[i], bodies_[k], memory_)) hits_.push_back({i, k});
            }
        }
    }

    std::vector<IndexPair> pairs() const override { return hits_; }
    std::size_t candidate_count() const override { return bodies_.size() * (bodies_.size() - 1) / 2; }

  private:
    std::vector<std::unique_ptr<MeshShape>> shapes_;
    std::vector<Posed<MeshShape>> bodies_;
    std::vector<IndexPair> hits_;
    QueryMemory memory_;
};

}  // namespace

std::unique_ptr<SceneEngine> set_up_world(const scenes::Scene& scene, BroadPhaseKind kind) {
    return std::make_unique<EcodsWorld>(scene, kind);
}

std::vector<SceneMaker> ecods_worlds() {
    std::vector<SceneMaker> makers;
    for (const auto& [kind, name] : broad_phase_kinds)
        makers.push_back({.name = std::string("ECoDS, ") + name, .is_ecods = true, .set_up = makes<EcodsWorld>(kind)});
    return makers;
}

std::vector<SceneMaker> ecods_all_pairs() {
    return {{.name = "ECoDS, all pairs", .is_ecods = true, .set_up = makes<EcodsAllPairs>()}};
}

}  // namespace ecods::bench
