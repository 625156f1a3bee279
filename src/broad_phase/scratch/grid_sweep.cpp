#include "broad_phase/scratch/grid_sweep.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/scratch/grid_sweep_loops.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Prefetches run this number of boxes ahead.
constexpr std::size_t prefetch_distance = 12;

}  // namespace

// Puts the boxes into their cells.
void GridSweep::arrange(std::span<const PackedBox> lines) {
    plan_ = plan_grid(lines);
    ranked_.resize(lines.size());
    dispatch<Loops::rank>(*this, lines);
    // Halves the numbers of cells while boxes are in too many cells: the plan is bad if the sample lacks many large
    // boxes.
    while (!count_cells(lines)) {
        for (std::uint32_t& count : plan_.cells) count = std::max(count / 2, 1u);
    }
    sort_begins(lines);
    fill_cells();
}

void GridSweep::append_order(std::span<const PackedBox> lines, std::vector<SlotIndex>& order) {
    arrange(lines);
    for (const Cell& cell : cells_) {
        const Loops::View rows = Loops::view(rows_.data() + cell.offset, cell.stride());
        for (std::uint32_t i = 0; i < cell.count; ++i) {
            if (rows.firsts[i] == Loops::first_of_both) order.push_back(static_cast<SlotIndex>(rows.slots[i]));
        }
    }
}

std::uint64_t GridSweep::find_pairs(std::span<const PackedBox> lines, std::vector<std::array<SlotIndex, 2>>& found) {
    arrange(lines);
    constexpr std::uint64_t tests_per_box = 512;
    const std::size_t before = found.size();
    Work work{.tests_max = tests_per_box * lines.size()};
    if (dispatch<Loops::sweep>(*this, lines, work, found)) return work.tests;
    found.resize(before);
    BoxForest forest;
    forest.build(lines);
    return work.tests + forest.find_pairs(found);
}

// Sets begins_ to the boxes that are not empty, sorted along the axis of the sweep, by radix sort of their ranks.
void GridSweep::sort_begins(std::span<const PackedBox> lines) {
    constexpr unsigned digit_bits = RankMap::rank_bits / 2;
    constexpr std::size_t digit_count = std::size_t{1} << digit_bits;
    static_assert(2 * digit_bits == RankMap::rank_bits);
    std::array<std::array<std::uint32_t, digit_count>, 2> next{};  // place of the next box with this digit
    begins_.clear();
    begins_.reserve(lines.size());
    const std::size_t axis = plan_.axes[0];
    for (SlotIndex slot = 0; slot < lines.size(); ++slot) {
        if (lines[slot].is_empty()) continue;
        const std::int32_t rank = ranked_[slot].begin[axis];
        begins_.push_back({rank, slot});
        ++next[0][static_cast<std::uint32_t>(rank) % digit_count];
        ++next[1][static_cast<std::uint32_t>(rank) / digit_count];
    }
    spare_.resize(begins_.size());
    for (unsigned pass = 0; pass < 2; ++pass) {
        std::uint32_t sum = 0;
        for (std::uint32_t& place : next[pass]) sum += std::exchange(place, sum);
        for (const Begin& begin : begins_) {
            spare_[next[pass][(static_cast<std::uint32_t>(begin.rank) >> (pass * digit_bits)) % digit_count]++] = begin;
        }
        begins_.swap(spare_);
    }
}

// Sets reached_, and the count and the offset of each cell. Returns false, with the work unfinished, if boxes are in
// too many cells and there is more than one cell, so that fewer cells help.
bool GridSweep::count_cells(std::span<const PackedBox> lines) {
    constexpr std::size_t entries_max = 12;  // average per box
    reached_.resize(lines.size());
    cells_.assign(plan_.cell_count(), {});
    std::size_t entries = 0;
    for (SlotIndex slot = 0; slot < lines.size(); ++slot) {
        if (lines[slot].is_empty()) continue;
        Reached& reached = reached_[slot];
        for (std::size_t k = 0; k < 2; ++k) {
            const std::size_t axis = plan_.axes[k + 1];
            reached.first[k] = static_cast<std::uint8_t>(cell_of(ranked_[slot].begin[axis], plan_.cells[k]));
            reached.last[k] = static_cast<std::uint8_t>(cell_of(ranked_[slot].end[axis], plan_.cells[k]));
        }
        for (std::size_t first = reached.first[0]; first <= reached.last[0]; ++first) {
            for (std::size_t second = reached.first[1]; second <= reached.last[1]; ++second) {
                ++cells_[first * plan_.cells[1] + second].count;
                ++entries;
            }
        }
        if (entries > entries_max * lines.size() && cells_.size() > 1) return false;
    }
    std::size_t offset = 0;
    for (Cell& cell : cells_) {
        cell.offset = offset;
        offset += row_count * cell.stride();
    }
    // Frees the old memory first, since nothing in it is needed, and reserves more, since the next search mostly needs
    // a little more.
    if (rows_.capacity() < offset) {
        release(rows_);
        rows_.reserve(offset + offset / 8);
    }
    rows_.resize(offset);
    return true;
}

void GridSweep::fill_cells() {
    for (const Cell& cell : cells_) {
        std::fill_n(rows_.data() + cell.offset + cell.count, padding, std::numeric_limits<std::int32_t>::max());
    }
    for (std::size_t i = 0; i < begins_.size(); ++i) {
        const SlotIndex ahead = begins_[std::min(i + prefetch_distance, begins_.size() - 1)].slot;
        __builtin_prefetch(&ranked_[ahead]);
        __builtin_prefetch(&reached_[ahead]);
        const SlotIndex slot = begins_[i].slot;
        const RankedBox& ranked = ranked_[slot];
        const Reached& reached = reached_[slot];
        for (std::size_t first = reached.first[0]; first <= reached.last[0]; ++first) {
            for (std::size_t second = reached.first[1]; second <= reached.last[1]; ++second) {
                Cell& cell = cells_[first * plan_.cells[1] + second];
                const std::size_t stride = cell.stride();
                std::int32_t* row = rows_.data() + cell.offset + cell.filled++;
                for (const std::size_t axis : plan_.axes) {
                    row[0] = ranked.begin[axis];
                    row[stride] = ranked.end[axis];
                    row += 2 * stride;
                }
                row[0] = static_cast<std::int32_t>(slot);
                row[stride] = (first == reached.first[0] ? 1 : 0) | (second == reached.first[1] ? 2 : 0);
            }
        }
    }
}

std::size_t GridSweep::bytes() const noexcept {
    return bytes_of(begins_, spare_) + bytes_of(ranked_) + bytes_of(reached_) + bytes_of(cells_) + bytes_of(rows_) +
           bytes_of(hits_);
}

}  // namespace ecods
