// ECoDS's broad phases, one after the other the same way.
#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

class BroadEcods final : public BroadEngine {
  public:
    BroadEcods(BroadPhaseKind kind, const scenes::MovingBoxes& boxes) : broad_phase_(make_broad_phase(kind)) {
        for (std::size_t i = 0; i < boxes.boxes.size(); ++i)
            broad_phase_->add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        proxies_.clear();
        moved_.clear();
        for (const scenes::BoxMove& move : moves) {
            if (move.is_new) {
                broad_phase_->remove(move.index);
                broad_phase_->add(move.index, move.box);
            } else {
                proxies_.push_back(move.index);
                moved_.push_back(move.box);
            }
        }
        broad_phase_->move(proxies_, moved_);
        broad_phase_->update();
        pairs_ = broad_phase_->pairs();  // asked here, because a broad phase may make the list when it is asked
    }

    std::span<const ProxyPair> pairs() const override { return pairs_; }

  private:
    std::unique_ptr<BroadPhase> broad_phase_;
    std::span<const ProxyPair> pairs_;
    std::vector<ProxyIndex> proxies_;  // that move in a frame
    std::vector<Aabb> moved_;
};

}  // namespace

std::unique_ptr<BroadEngine> set_up_broad_ecods(BroadPhaseKind kind, const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadEcods>(kind, boxes);
}

}  // namespace ecods::bench
