// ECoDS without its manager: every pair of bodies is given to the two-body query, every frame. What the report calls
// pair-wise testing.
#include "ecods/intersection.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

namespace {

class EcodsAllPairs final : public Engine {
  public:
    explicit EcodsAllPairs(const scenes::Scene& scene) {
        for (const scenes::NamedMesh& named : scene.meshes) shapes_.push_back(std::make_unique<MeshShape>(named.mesh));
        for (const scenes::SceneBody& body : scene.bodies)
            bodies_.push_back({shapes_[body.mesh_index].get(), body.pose});
    }

    void run_frame(std::span<const scenes::Move> moves) override {
        for (const scenes::Move& move : moves) bodies_[move.body_index].pose = move.pose;
        hits_.clear();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            for (std::size_t k = i + 1; k < bodies_.size(); ++k) {
                const Body &a = bodies_[i], &b = bodies_[k];
                if (intersects({*a.shape, a.pose}, {*b.shape, b.pose}, memory_)) hits_.push_back({i, k});
            }
        }
    }

    std::vector<IndexPair> hits() const override { return hits_; }
    std::size_t candidate_count() const override { return bodies_.size() * (bodies_.size() - 1) / 2; }

  private:
    struct Body {
        const MeshShape* shape = nullptr;
        Pose pose;
    };

    std::vector<std::unique_ptr<MeshShape>> shapes_;
    std::vector<Body> bodies_;
    std::vector<IndexPair> hits_;
    QueryMemory memory_;
};

}  // namespace

std::unique_ptr<Engine> set_up_ecods_all_pairs(const scenes::Scene& scene) {
    return std::make_unique<EcodsAllPairs>(scene);
}

}  // namespace ecods::bench
