// ECoDS's search from scratch, at every frame: what its broad phases do when everything is to be looked up, and the
// least that one must be worth that keeps anything.
#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "broad_phase/scratch/sort_and_sweep.hpp"
#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

// Pairs ascending, and those that began and ended, as with a BroadPhase.
class BroadScratch final : public BroadEngine {
  public:
    explicit BroadScratch(const scenes::MovingBoxes& boxes) {
        for (std::size_t i = 0; i < boxes.boxes.size(); ++i) table_.add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) {
            if (move.is_new) {
                table_.remove(move.index);
                table_.add(move.index, move.box);
            } else {
                table_.move(move.index, move.box);
            }
        }
        pairs_.begin_update();
        events_.clear();
        const ProxyChanges& changes = table_.collect();
        if (!changes.empty()) {
            finder_.update(
                {.table = table_, .changes = changes, .keeper = pairs_, .events = events_, .counts = counts_});
        }
        table_.settle();
        pairs_.end_update();
        listed_ = pairs_.sorted();
    }

    std::span<const ProxyPair> pairs() const override { return listed_; }

  private:
    ProxyTable table_;
    PairEvents events_;
    PairList pairs_{events_};
    SortAndSweep finder_;
    BroadPhaseCounts counts_;
    std::span<const ProxyPair> listed_;
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
