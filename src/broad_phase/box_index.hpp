// An index of the boxes that are present, for questions about one box, segment or ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Trees of fat boxes. A box that stays in its fat box costs a comparison when the index is brought up to date, and
// one that left it a new place in a tree. Slots are proxies.
class BoxIndex {
  public:
    // The box of this proxy came, went or moved. Where memory for that is lacking, the index starts from scratch with
    // the next refresh().
    void note(ProxyIndex proxy) noexcept;

    // Makes the fat boxes contain the boxes of `table`. Cost: proportional to the proxies noted since it was called
    // last, and at times n log n, which has been paid for by n / 4 boxes that came or n that left their fat boxes. If
    // memory ends, it starts from scratch the next time. Returns the number of boxes that it looked at.
    std::uint64_t refresh(const ProxyTable& table);

    // Appends the proxies whose fat boxes overlap; as those of BoxTree. After refresh().
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<ProxyIndex>& found) const {
        ECODS_ASSERT(is_built_ && noted_.empty());
        return forest_.find(bounds, found);
    }

    // The trees of fat boxes. After refresh().
    std::span<const BoxTree> trees() const noexcept {
        ECODS_ASSERT(is_built_ && noted_.empty());
        return forest_.trees();
    }

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless each box is in its fat box, and the trees are right. After refresh().
    void validate(const ProxyTable& table) const;

  private:
    void build(const ProxyTable& table);
    void catch_up(const ProxyTable& table);
    void clear() noexcept;

    bool is_built_ = false;
    BoxForest forest_;
    std::vector<PackedBox> fat_lines_;    // by proxy; empty where none is present
    std::vector<ProxyIndex> noted_;       // since the last refresh, each once
    std::vector<std::uint8_t> is_noted_;  // by proxy
    std::size_t escaped_since_build_ = 0;
};

}  // namespace ecods
