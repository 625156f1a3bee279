// Finds the pairs that would overlap if some boxes were replaced by others.
#include "broad_phase/overlap_tracker.hpp"
#include "broad_phase/sweep/find_pairs.hpp"

namespace ecods {

void OverlapTracker::find_pairs_among(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes,
                                      ProxyPairs& found) const {
    count_find(ChosenBoxes(chosen, boxes).find_pairs_among(found));
}

// If fewer than one box in 16 is chosen, looks up each chosen box among all boxes. Otherwise looks up each other box
// among the chosen boxes, which costs less per query.
void OverlapTracker::find_pairs_with(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes,
                                     ProxyPairs& found) const {
    constexpr std::size_t few = 16;
    const ChosenBoxes trees(chosen, boxes);
    std::uint64_t tests = trees.find_pairs_among(found);
    if (few * chosen.size() < table_.size()) {
        const std::vector<std::uint8_t> is_chosen = trees.marks(table_.end());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            visit_near(boxes[i], 0, [&](ProxyIndex proxy) {
                if (is_chosen[proxy] == 0) found.push_back(ordered_pair(proxy, chosen[i]));
                return 0;
            });
        }
    } else {
        tests += trees.find_pairs_with_others(table_, found);
    }
    count_find(tests);
}

}  // namespace ecods
