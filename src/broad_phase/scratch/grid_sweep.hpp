// Finds all pairs of overlapping boxes from scratch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/scratch/grid_plan.hpp"

namespace ecods {

// Sort and sweep in the columns of a grid: boxes are sorted along one axis and put in that order into each cell of the
// other two axes that they reach. In each cell, a box is compared with the boxes that begin before it ends, eight at
// once. A pair is reported in the first cell, on both axes, that both boxes reach, and in no other. Ends are ranks, for
// which half as many bits suffice (grid_plan.hpp); if two ranks are equal, the boxes themselves decide. If the sweep
// takes many tests for few pairs, it is given up for trees, which no arrangement makes slow. (The sweep is from D.
// Baraff's thesis, 1992. That a sweep from scratch, over integers that are contiguous in memory, may cost less than
// keeping its lists is from P. Terdiman, "Box pruning revisited".)
//
// The scratch memory is kept for the next search.
class GridSweep {
  public:
    // Appends all pairs of slots whose boxes overlap, each once, in no order. Empty lines overlap none. Returns the
    // number of box tests. Cost: a few passes over the boxes, and a test for each two boxes of a cell that overlap on
    // the axis of the sweep, up to the number of tests beyond which trees cost less. If memory runs out, `found` has
    // some of the pairs.
    std::uint64_t find_pairs(std::span<const PackedBox> lines, std::vector<std::array<SlotIndex, 2>>& found);

    // Appends the slots of all lines that are not empty, in the order in which the search goes through boxes:
    // neighbours are mostly close to each other.
    void append_order(std::span<const PackedBox> lines, std::vector<SlotIndex>& order);

    std::size_t bytes() const noexcept;

  private:
    // The ranks of a box on three axes, and the cells that it reaches.
    struct alignas(32) RankedBox {
        std::array<std::int32_t, 4> begin;
        std::array<std::int32_t, 4> end;
    };
    struct Reached {
        std::array<std::uint8_t, 2> first;
        std::array<std::uint8_t, 2> last;
    };
    struct Begin {
        std::int32_t rank;
        SlotIndex slot;
    };
    // A cell has eight rows of numbers: the begins and ends of its boxes on three axes, in the order of the sweep,
    // their slots, and bits for the axes on which the cell is the first one that the box reaches.
    struct Cell {
        std::size_t offset = 0;  // offset of the first row
        std::uint32_t count = 0;
        std::uint32_t filled = 0;
        std::size_t stride() const noexcept { return count + padding; }
    };
    // Boxes of a cell that may overlap box `own`: bits of eight boxes, from `first` on. Hits are collected and
    // processed in bulk, so that the sweep does not wait for the memory that processing reads.
    struct Hits {
        std::uint32_t own;
        std::uint32_t first;
        std::uint32_t bits;
    };
    // Bounds the work. Most tests find nothing if boxes are at places so far apart that all boxes of one place have
    // equal ranks.
    struct Work {
        std::uint64_t tests = 0;
        std::uint64_t tests_max;

        bool goes_on(std::size_t found_count) noexcept {
            constexpr std::uint64_t tests_per_pair = 32;
            if (tests <= tests_max) return true;
            tests_max *= 2;
            return tests < tests_per_pair * found_count;
        }
    };
    // Each row ends with padding, which the sweep may read: its boxes begin after all others end.
    static constexpr std::size_t padding = 8;
    static constexpr std::size_t row_count = 8;

    struct Loops;  // functions compiled for each instruction set, in grid_sweep_loops.hpp

    void arrange(std::span<const PackedBox> lines);
    void sort_begins(std::span<const PackedBox> lines);
    bool count_cells(std::span<const PackedBox> lines);
    void fill_cells();

    GridPlan plan_;
    std::vector<RankedBox> ranked_;  // by slot
    std::vector<Reached> reached_;   // by slot
    std::vector<Begin> begins_, spare_;
    std::vector<Cell> cells_;
    std::vector<std::int32_t> rows_;
    std::vector<Hits> hits_;
};

}  // namespace ecods
