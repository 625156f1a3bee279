// Indexes the boxes that are present, for queries by a box, a segment or a ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Holds trees of fat boxes, which are boxes enlarged by margins; the trees' slots are proxies. At a refresh(), a box
// that moved within its fat box costs a comparison, and a box that left its fat box gets a new fat box.
class BoxIndex {
  public:
    // Notes that the box of this proxy was added, removed or moved since the last refresh(). If memory runs out, the
    // next refresh() builds the index from scratch.
    void note(ProxyIndex proxy) noexcept;

    // Brings the index up to date: makes the fat boxes contain the boxes of `table`. Returns the number of boxes
    // examined. Cost: proportional to the number of proxies noted since the last call. Some calls build the index from
    // scratch, which costs n log n and is amortized over n / 4 boxes added or n boxes that left their fat boxes. If
    // memory runs out, the next call builds the index from scratch.
    std::uint64_t refresh(const ProxyTable& table);

    // Appends to `found` the proxies whose fat boxes meet `bounds`, and returns the number of box tests, as
    // BoxTree::find does. Call refresh() first.
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

    // Throws BrokenInvariant unless each box is inside its fat box and the trees are valid. Call refresh() first.
    void validate(const ProxyTable& table) const;

  private:
    void build(const ProxyTable& table);
    void catch_up(const ProxyTable& table);
    void clear() noexcept;

    bool is_built_ = false;
    BoxForest forest_;
    std::vector<PackedBox> fat_lines_;    // fat boxes by proxy; empty if the proxy is not present
    std::vector<ProxyIndex> noted_;       // proxies noted since the last refresh, each once
    std::vector<std::uint8_t> is_noted_;  // by proxy: 1 if the proxy is in noted_
    std::size_t escaped_since_build_ = 0;
};

}  // namespace ecods
