#include <bit>
#include <utility>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/box_tree_walk.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Appends make(query, child) to `results` for each lane of each visit. Leaves `visits` with unspecified contents. Each
// pass takes one lane of each visit and keeps the visits with more lanes: an inner loop over the lanes of a visit would
// mispredict its end.
template <class Result, class Make>
ECODS_ALWAYS_INLINE void append_children(std::vector<BlockVisit>& visits, std::vector<Result>& results,
                                         const Make& make) {
    for (std::size_t left = 0, count = visits.size(); count != 0; count = std::exchange(left, 0)) {
        const std::size_t before = results.size();
        results.resize(before + count);
        Result* write = results.data() + before;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [query, block, lanes] = visits[i];
            *write++ = make(query, block * BoxBlock::width + static_cast<std::uint32_t>(std::countr_zero(lanes)));
            visits[left] = {query, block, lanes & (lanes - 1)};
            left += visits[left].lanes != 0 ? 1 : 0;
        }
    }
}

// Sets the lanes of each visit to the lanes that overlap the box of its query, and drops the visits that have none.
ECODS_ALWAYS_INLINE void visit_blocks(const std::vector<BoxBlock>& blocks, std::span<const BoxReach> reaches,
                                      std::vector<BlockVisit>& visits) {
    std::size_t count = 0;
    for (const BlockVisit visit : visits) {
        visits[count] = {visit.query, visit.block, overlapping(blocks[visit.block], reaches[visit.query])};
        count += visits[count].lanes != 0 ? 1 : 0;
    }
    visits.resize(count);
}

// Implements BoxTree::find_each. Searches level by level: the blocks of a level are prefetched while the level above is
// processed, and no branch depends on the results.
ECODS_ALWAYS_INLINE std::uint64_t find_each_slot(const BoxLevels& levels, const std::vector<SlotIndex>& slots,
                                                 std::span<const BoxReach> reaches, BlockVisits& visits,
                                                 std::vector<FoundBox>& found) {
    auto& [visited, next] = visits;
    visited.clear();
    for (std::uint32_t query = 0; query < reaches.size(); ++query) visited.push_back({query, 0, 0});
    std::uint64_t tests = 0;
    for (std::size_t level = levels.size() - 1;; --level) {
        tests += BoxBlock::width * visited.size();
        visit_blocks(levels[level], reaches, visited);
        if (level == 0) break;
        next.clear();
        append_children(visited, next, [below = levels[level - 1].data()](std::uint32_t query, std::uint32_t block) {
            prefetch_block(below[block]);
            return BlockVisit{query, block, 0};
        });
        visited.swap(next);
    }
    append_children(visited, found, [&](std::uint32_t query, std::uint32_t position) {
        return FoundBox{query, slots[position]};
    });
    return tests;
}

}  // namespace

std::uint64_t BoxTree::find_each(std::span<const BoxReach> reaches, BlockVisits& visits,
                                 std::vector<FoundBox>& found) const {
    return dispatch<find_each_slot>(levels_, slots_, reaches, visits, found);
}

}  // namespace ecods
