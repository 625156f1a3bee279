// An index of the boxes that are present, for queries by one box, segment or ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Trees of fat boxes. When the index is brought up to date, a box that is still in its fat box costs a comparison, and
// one that left it gets a new place in a tree. Slots are proxies.
class BoxIndex {
  public:
    // Notes that the box of this proxy came, went or moved. If memory runs out, the next refresh() builds the index
    // from scratch.
    void note(ProxyIndex proxy) noexcept;

    // Makes the fat boxes contain the boxes of `table`, and returns the number of boxes examined. Cost: proportional to
    // the proxies noted since the last call; at times n log n, which is amortized over n / 4 boxes that came or n that
    // left their fat boxes. If memory runs out, the next call builds the index from scratch.
    std::uint64_t refresh(const ProxyTable& table);

    // Appends the proxies whose fat boxes meet `bounds`, and returns the number of box tests, as BoxTree::find does.
    // Call refresh() first.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<ProxyIndex>& found) const {
        ECODS_ASSERT(is_built_ && noted_.empty());
        return forest_.find(bounds, found);
    }

    // Returns the trees of fat boxes. Call refresh() first.
    std::span<const BoxTree> trees() const noexcept {
        ECODS_ASSERT(is_built_ && noted_.empty());
        return forest_.trees();
    }

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless each box is in its fat box, and the trees are valid. Call refresh() first.
    void validate(const ProxyTable& table) const;

  private:
    void build(const ProxyTable& table);
    void catch_up(const ProxyTable& table);
    void clear() noexcept;

    bool is_built_ = false;
    BoxForest forest_;
    std::vector<PackedBox> fat_lines_;    // by proxy; empty if the proxy is not present
    std::vector<ProxyIndex> noted_;       // proxies noted since the last refresh, each once
    std::vector<std::uint8_t> is_noted_;  // by proxy
    std::size_t escaped_since_build_ = 0;
};

}  // namespace ecods
