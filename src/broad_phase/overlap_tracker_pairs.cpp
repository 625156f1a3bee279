// The pairs that overlap when some boxes are others than they are.
#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/overlap_tracker.hpp"

namespace ecods {
namespace {

// Where fewer than one in so many are chosen, each of them is looked up among all boxes; otherwise all boxes are looked
// up among them, which costs less for each.
constexpr std::size_t few = 16;

}  // namespace

// The trees of some boxes that stand in place of those of the chosen: slots are places in `chosen`.
class ChosenForest {
  public:
    explicit ChosenForest(std::span<const Aabb> boxes) : lines_(boxes.size()), items_(boxes.size()) {
        for (SlotIndex slot = 0; slot < boxes.size(); ++slot) {
            make_packed_box(boxes[slot], lines_[slot]);
            items_[slot] = BoxForest::make_item(boxes[slot], slot);
        }
        forest_.build(items_, lines_);
    }

    std::uint64_t find_pairs(std::span<const ProxyIndex> chosen, ProxyPairs& found) {
        std::vector<std::array<SlotIndex, 2>> among;
        const std::uint64_t tests = forest_.find_pairs(among);
        for (const auto& [a, b] : among) found.push_back(ordered_pair(chosen[a], chosen[b]));
        return tests;
    }
    const BoxForest& forest() const noexcept { return forest_; }

  private:
    std::vector<PackedBox> lines_;
    std::vector<BoxForest::Item> items_;
    BoxForest forest_;
};

void OverlapTracker::find_pairs_among(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes,
                                      ProxyPairs& found) const {
    count_find(ChosenForest(boxes).find_pairs(chosen, found));
}

void OverlapTracker::find_pairs_with(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes,
                                     ProxyPairs& found) const {
    ChosenForest trees(boxes);
    const BoxForest& forest = trees.forest();
    std::uint64_t tests = trees.find_pairs(chosen, found);
    std::vector<std::uint8_t> is_chosen(table_.end());
    for (const ProxyIndex proxy : chosen) is_chosen[proxy] = 1;

    if (few * chosen.size() < table_.size()) {
        for (SlotIndex slot = 0; slot < chosen.size(); ++slot) {
            visit_near(boxes[slot], 0, [&](ProxyIndex proxy) {
                if (is_chosen[proxy] == 0) found.push_back(ordered_pair(proxy, chosen[slot]));
                return 0;
            });
        }
    } else {
        std::vector<SlotIndex> overlapping;
        PackedBox line;
        BoxReach reach;
        for (ProxyIndex proxy = 0; proxy < table_.end(); ++proxy) {
            if (is_chosen[proxy] != 0 || !table_.is_present(proxy)) continue;
            make_packed_box(table_.boxes()[proxy], line);
            make_reach(line, reach);
            overlapping.clear();
            tests += forest.find(reach, overlapping);
            for (const SlotIndex slot : overlapping) found.push_back(ordered_pair(proxy, chosen[slot]));
        }
    }
    count_find(tests);
}

}  // namespace ecods
