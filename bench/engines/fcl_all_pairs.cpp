// FCL without a manager: every pair of bodies, every frame.
#include "engines/engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

class FclAllPairs final : public Engine {
  public:
    explicit FclAllPairs(const scenes::Scene& scene) : objects_(to_fcl(scene)) {}

    void run_frame(std::span<const scenes::Move> moves) override {
        for (const scenes::Move& next : moves) move(*objects_[next.body_index], next.pose);
        hits_.clear();
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            for (std::size_t k = i + 1; k < objects_.size(); ++k) {
                if (collide(*objects_[i], *objects_[k])) hits_.push_back({i, k});
            }
        }
    }

    std::vector<IndexPair> hits() const override { return hits_; }
    std::size_t candidate_count() const override { return objects_.size() * (objects_.size() - 1) / 2; }

  private:
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    std::vector<IndexPair> hits_;
};

}  // namespace

std::unique_ptr<Engine> set_up_fcl_all_pairs(const scenes::Scene& scene) {
    return std::make_unique<FclAllPairs>(scene);
}

}  // namespace ecods::bench
