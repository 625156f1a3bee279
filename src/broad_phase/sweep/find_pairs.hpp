// Overlapping pairs without temporal coherence: all, or those of some boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/pair_finder.hpp"

namespace ecods {

// Appends the pairs that overlap and of which at least one is `chosen`, in no order, each once. All chosen proxies
// are present. Returns the number of box tests. Cost: sorting the chosen into trees, and a query for each box present.
std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found);

// Makes the events of an update the differences between the pairs kept and all pairs of now.
void update_from_scratch(const FindingUpdate& update);

// Trees of boxes that stand in place of those of some chosen proxies, each of which is chosen once. Both lists must
// outlive it. Its calls append pairs and return the number of box tests.
class ChosenBoxes {
  public:
    ChosenBoxes(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes);

    std::uint64_t find_pairs_among(ProxyPairs& found) const;
    std::uint64_t find_pairs_with_others(const ProxyTable& table, ProxyPairs& found) const;

    // By proxy below `end`: 1 of those that are chosen.
    std::vector<std::uint8_t> marks(ProxyIndex end) const;

  private:
    std::span<const ProxyIndex> chosen_;
    BoxForest forest_;  // slots are places in `chosen`
};

}  // namespace ecods
