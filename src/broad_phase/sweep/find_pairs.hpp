// Finds overlapping pairs without temporal coherence: all pairs, or the pairs of some boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/pair_finder.hpp"

namespace ecods {

// Appends to `found` the overlapping pairs with at least one proxy in `chosen`, each once, in no order. All chosen
// proxies must be present. Returns the number of box tests. Cost: building trees of the chosen boxes, and a query for
// each box present.
std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found);

// Finds all pairs that overlap now, and sets update.events to their differences from the keeper's pairs.
void update_from_scratch(const FindingUpdate& update);

// Holds trees of `boxes`, which the proxies in `chosen` have in a search instead of their own boxes. Each proxy is
// listed once. Both lists must outlive the object. The functions that find pairs append them to `found` and return the
// number of box tests.
class ChosenBoxes {
  public:
    ChosenBoxes(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes);

    std::uint64_t find_pairs_among(ProxyPairs& found) const;
    std::uint64_t find_pairs_with_others(const ProxyTable& table, ProxyPairs& found) const;

    // Returns a mark for each proxy less than `end`: 1 if the proxy is chosen, otherwise 0.
    std::vector<std::uint8_t> marks(ProxyIndex end) const;

  private:
    std::span<const ProxyIndex> chosen_;
    BoxForest forest_;  // slots are indices in chosen_
};

}  // namespace ecods
