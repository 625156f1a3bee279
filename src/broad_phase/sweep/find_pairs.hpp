// Finds overlapping pairs without temporal coherence: all pairs, or the pairs of some boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/pair_finder.hpp"

namespace ecods {

// Appends the overlapping pairs with at least one proxy in `chosen`, in no order, each once. All chosen proxies must be
// present. Returns the number of box tests. Cost: sorting the chosen into trees, and a query for each box present.
std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found);

// Sets the events of an update to the differences between the kept pairs and all pairs that overlap now.
void update_from_scratch(const FindingUpdate& update);

// Trees of boxes that replace the boxes of the proxies in `chosen`, each listed once. Both lists must outlive the
// object. Its functions append pairs and return the number of box tests.
class ChosenBoxes {
  public:
    ChosenBoxes(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes);

    std::uint64_t find_pairs_among(ProxyPairs& found) const;
    std::uint64_t find_pairs_with_others(const ProxyTable& table, ProxyPairs& found) const;

    // Returns a mark for each proxy below `end`: 1 if it is chosen.
    std::vector<std::uint8_t> marks(ProxyIndex end) const;

  private:
    std::span<const ProxyIndex> chosen_;
    BoxForest forest_;  // slots are places in `chosen`
};

}  // namespace ecods
