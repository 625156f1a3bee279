// ECoDS's search from scratch, at every frame: what its broad phases do when everything is to be looked up, and the
// least that one must be worth that keeps anything.
#include "broad_phase/scratch/grid_sweep.hpp"
#include "engines/broad_engine.hpp"
#include "engines/sort_and_sweep.hpp"

namespace ecods::bench {

namespace {

// Pairs ascending, and those that began and ended, as with a BroadPhase.
class BroadScratch final : public BroadEngine {
  public:
    explicit BroadScratch(const scenes::MovingBoxes& boxes) {
        for (std::size_t i = 0; i < boxes.boxes.size(); ++i) search_.add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) {
            if (move.is_new) {
                search_.remove(move.index);
                search_.add(move.index, move.box);
            } else {
                search_.move(move.index, move.box);
            }
        }
        search_.update();
        pairs_ = search_.pairs();
    }

    std::span<const ProxyPair> pairs() const override { return pairs_; }

  private:
    SortAndSweep search_;
    std::span<const ProxyPair> pairs_;
};

// The pairs alone, as they are found: what searches of other libraries deliver.
class BroadScratchUnsorted final : public BroadEngine {
  public:
    explicit BroadScratchUnsorted(const scenes::MovingBoxes& boxes) : lines_(boxes.boxes.size()) {
        for (std::size_t i = 0; i < lines_.size(); ++i) make_packed_box(boxes.boxes[i], lines_[i]);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) make_packed_box(move.box, lines_[move.index]);
        found_.clear();
        search_.find_pairs(lines_, found_);
        pairs_.resize(found_.size());
        for (std::size_t i = 0; i < found_.size(); ++i) pairs_[i] = ordered_pair(found_[i][0], found_[i][1]);
    }

    std::span<const ProxyPair> pairs() const override { return pairs_; }

  private:
    std::vector<PackedBox> lines_;
    GridSweep search_;
    std::vector<std::array<SlotIndex, 2>> found_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::unique_ptr<BroadEngine> set_up_broad_scratch(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadScratch>(boxes);
}

std::unique_ptr<BroadEngine> set_up_broad_scratch_unsorted(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadScratchUnsorted>(boxes);
}

}  // namespace ecods::bench
