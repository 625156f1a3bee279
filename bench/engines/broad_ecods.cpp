// ECoDS's broad phases, one after the other the same way; and its search from scratch at every frame, which is what
// they do when everything is to be looked up, and the least that one must be worth that keeps anything.
#include "broad_phase/scratch/grid_sweep.hpp"
#include "engines/broad_engine.hpp"
#include "engines/broad_phase_kinds.hpp"
#include "engines/sort_and_sweep.hpp"

namespace ecods::bench {

namespace {

template <class Search>
void add_all(Search& search, const scenes::MovingBoxes& boxes) {
    for (std::size_t i = 0; i < boxes.boxes.size(); ++i) search.add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
}

template <class Search>
void replace(Search& search, const scenes::BoxMove& move) {
    search.remove(move.index);
    search.add(move.index, move.box);
}

class BroadEcods final : public BroadEngine {
  public:
    BroadEcods(const scenes::MovingBoxes& boxes, BroadPhaseKind kind) : broad_phase_(make_broad_phase(kind)) {
        add_all(*broad_phase_, boxes);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        proxies_.clear();
        moved_.clear();
        for (const scenes::BoxMove& move : moves) {
            if (move.is_new) {
                replace(*broad_phase_, move);
            } else {
                proxies_.push_back(move.index);
                moved_.push_back(move.box);
            }
        }
        broad_phase_->move(proxies_, moved_);
        broad_phase_->update();
        pairs_ = broad_phase_->pairs();  // asked here, because a broad phase may make the list when it is asked
    }

    std::vector<ProxyPair> pairs() const override { return {pairs_.begin(), pairs_.end()}; }

  private:
    std::unique_ptr<BroadPhase> broad_phase_;
    std::span<const ProxyPair> pairs_;
    std::vector<ProxyIndex> proxies_;  // that move in a frame
    std::vector<Aabb> moved_;
};

// Pairs ascending, and those that began and ended, as with a BroadPhase.
class BroadScratch final : public BroadEngine {
  public:
    explicit BroadScratch(const scenes::MovingBoxes& boxes) { add_all(search_, boxes); }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) {
            if (move.is_new) {
                replace(search_, move);
            } else {
                search_.move(move.index, move.box);
            }
        }
        search_.update();
        pairs_ = search_.pairs();
    }

    std::vector<ProxyPair> pairs() const override { return {pairs_.begin(), pairs_.end()}; }

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

    std::vector<ProxyPair> pairs() const override { return pairs_; }

  private:
    std::vector<PackedBox> lines_;
    GridSweep search_;
    std::vector<std::array<SlotIndex, 2>> found_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::vector<BroadMaker> ecods_broad() {
    std::vector<BroadMaker> makers;
    for (const auto& [kind, name] : broad_phase_kinds) {
        BroadMaker& maker = makers.emplace_back();
        maker = {.name = std::string("ECoDS, ") + name,
                 .use = "BroadPhase: move(), update(), pairs()",
                 .is_ecods = true,
                 .set_up = makes<BroadEcods>(kind)};
        // Every box against every other: for small scenes.
        if (kind == BroadPhaseKind::brute_force) maker.traits.count_max = 1000;
    }
    return makers;
}

std::vector<BroadMaker> scratch_broad() {
    return {
        {.name = broad_scratch,
         .use = "internal: everything sorted and swept in each frame; pairs ascending, and those that came and went",
         .is_ecods = true,
         .set_up = makes<BroadScratch>()},
        {.name = broad_scratch_unsorted,
         .use = "internal: the same; pairs in the order in which they are found, and nothing else",
         .is_ecods = true,
         .set_up = makes<BroadScratchUnsorted>()}};
}

}  // namespace ecods::bench
