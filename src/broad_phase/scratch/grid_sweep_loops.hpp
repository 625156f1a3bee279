// Implements the loops of GridSweep over all boxes; they are compiled for each instruction set (simd/dispatch.hpp).
#pragma once

#include <bit>
#include <utility>

#include "broad_phase/scratch/grid_sweep.hpp"
#include "simd/inline.hpp"
#include "simd/mask_bits.hpp"

namespace ecods {

struct GridSweep::Loops {
    using Lanes = Vec<std::int32_t, 8>;

    // Points to the eight rows of a cell; names without a number are for the axis of the sweep.
    struct View {
        const std::int32_t *begin, *end, *begin_1, *end_1, *begin_2, *end_2, *slots, *firsts;
    };
    ECODS_ALWAYS_INLINE static View view(const std::int32_t* row, std::size_t stride) noexcept {
        return {row,
                row + stride,
                row + 2 * stride,
                row + 3 * stride,
                row + 4 * stride,
                row + 5 * stride,
                row + 6 * stride,
                row + 7 * stride};
    }

    static constexpr std::int32_t first_of_both = 3;

    // Appends to `found` the overlapping pairs among the collected hits, `noted`, of a cell, except pairs that another
    // cell reports, the first cell that both boxes reach. Each pass takes one pair of each hit and keeps the hits that
    // have more pairs: an inner loop over the bits of a hit would mispredict its end, which costs more than the work
    // for a pair.
    [[gnu::noinline]] static void take(std::span<Hits> noted, const View& cell, std::span<const PackedBox> lines,
                                       std::vector<std::array<SlotIndex, 2>>& found) {
        for (std::size_t left = 0, count = noted.size(); count != 0; count = std::exchange(left, 0)) {
            const std::size_t before = found.size();
            found.resize(before + count);
            std::array<SlotIndex, 2>* write = found.data() + before;
            for (std::size_t i = 0; i < count; ++i) {
                const auto [a, first, bits] = noted[i];
                const std::uint32_t b = first + static_cast<std::uint32_t>(std::countr_zero(bits));
                noted[left] = {a, first, bits & (bits - 1)};
                left += noted[left].bits != 0 ? 1 : 0;
                const auto slot_a = static_cast<SlotIndex>(cell.slots[a]),
                           slot_b = static_cast<SlotIndex>(cell.slots[b]);
                *write = {slot_a, slot_b};
                const bool is_here = (cell.firsts[a] | cell.firsts[b]) == first_of_both;
                const bool is_certain = (cell.begin[b] < cell.end[a]) & (cell.begin[a] < cell.end[b]) &
                                        (cell.begin_1[b] < cell.end_1[a]) & (cell.begin_1[a] < cell.end_1[b]) &
                                        (cell.begin_2[b] < cell.end_2[a]) & (cell.begin_2[a] < cell.end_2[b]);
                if (!is_certain && !overlap(lines[slot_a], lines[slot_b])) [[unlikely]]
                    continue;
                write += is_here ? 1 : 0;
            }
            found.resize(static_cast<std::size_t>(write - found.data()));
        }
    }

    // Sweeps all cells and appends their pairs to `found`. Returns false if it gave up, since most tests found nothing.
    ECODS_ALWAYS_INLINE static bool sweep(GridSweep& self, std::span<const PackedBox> lines, Work& work,
                                          std::vector<std::array<SlotIndex, 2>>& found) {
        for (const Cell& cell : self.cells_) {
            const View rows = view(self.rows_.data() + cell.offset, cell.stride());
            if (!sweep_cell(rows, cell.count, self.hits_, lines, work, found)) return false;
        }
        return true;
    }

    // Tests each box of a cell against the boxes that come later in the order of the sweep and begin before it ends. On
    // the other two axes, two boxes are apart if one begins after the other ends. Returns false if it gave up.
    ECODS_ALWAYS_INLINE static bool sweep_cell(const View& cell, std::uint32_t count, std::vector<Hits>& hits,
                                               std::span<const PackedBox> lines, Work& work,
                                               std::vector<std::array<SlotIndex, 2>>& found) {
        constexpr std::uint32_t width = lane_count<Lanes>;
        static_assert(width <= padding);
        // Processes noted hits only after a box has been tested against all its successors, and only if there are at
        // least `enough` hits or the sweep of the cell ends. A branch on each group of tests would be unpredictable,
        // and would cost more than the tests.
        constexpr std::size_t enough = 512;
        if (hits.size() < enough + count / width + 1) hits.resize(enough + count / width + 1);
        Hits* const noted = hits.data();
        Hits* next = noted;
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            const std::int32_t last = cell.end[i];
            const std::int32_t begin_1 = cell.begin_1[i], end_1 = cell.end_1[i];
            const std::int32_t begin_2 = cell.begin_2[i], end_2 = cell.end_2[i];
            std::uint32_t k = i + 1;
            do {
                const Lanes beyond =
                    (load_anywhere<Lanes>(cell.begin + k) > last) | (load_anywhere<Lanes>(cell.begin_1 + k) > end_1) |
                    (load_anywhere<Lanes>(cell.end_1 + k) < begin_1) |
                    (load_anywhere<Lanes>(cell.begin_2 + k) > end_2) | (load_anywhere<Lanes>(cell.end_2 + k) < begin_2);
                const std::uint32_t bits = mask_bits(beyond) ^ ((1u << width) - 1);
                *next = {i, k, bits};
                next += bits != 0 ? 1 : 0;
                k += width;
            } while (cell.begin[k - 1] <= last);
            work.tests += k - i - 1;
            if (next >= noted + enough || work.tests > work.tests_max) [[unlikely]] {
                take({noted, next}, cell, lines, found);
                next = noted;
                if (!work.goes_on(found.size())) return false;
            }
        }
        if (next != noted) take({noted, next}, cell, lines, found);
        return true;
    }

    ECODS_ALWAYS_INLINE static void rank(GridSweep& self, std::span<const PackedBox> lines) {
        const RankMap map = self.plan_.map;
        for (SlotIndex slot = 0; slot < lines.size(); ++slot) {
            BoxLanes ends;
            load_lanes(lines[slot], ends);
            const KeyLanes nothing{};
            store(self.ranked_[slot].begin.data(), map.at(shuffle<0, 1, 2, 4>(ends.first, nothing)));
            store(self.ranked_[slot].end.data(), map.at(shuffle<1, 2, 3, 4>(~ends.second, nothing)));
        }
    }
};

}  // namespace ecods
