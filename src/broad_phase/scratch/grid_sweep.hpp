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

// Sorts and sweeps in the columns of a grid. Boxes are sorted along one axis and put in that order into each cell of
// the other two axes that they reach. In each cell, a box is compared with the boxes that begin before it ends, eight
// at once. A pair is reported only in the first cell, on both axes, that both boxes reach. The sweep compares ranks
// (grid_plan.hpp), which have half as many bits as coordinates; if two ranks are equal, the boxes are compared. If the
// sweep takes many tests for few pairs, a search in trees replaces it, which no arrangement of boxes makes slow. (The
// sweep is from D. Baraff's thesis, 1992. P. Terdiman, "Box pruning revisited", found that a sweep from scratch over
// contiguous integers may cost less than keeping its lists.)
//
// The object keeps its scratch memory for the next search.
class GridSweep {
  public:
    // Appends all pairs of slots whose boxes overlap, each once, in no order. An empty line overlaps no other. Returns
    // the number of box tests. Cost: a few passes over the boxes, and a test for each two boxes of a cell that overlap
    // on the axis of the sweep, up to the number of tests above which trees cost less. If memory runs out, `found` has
    // some of the pairs.
    std::uint64_t find_pairs(std::span<const PackedBox> lines, std::vector<std::array<SlotIndex, 2>>& found);

    // Appends the slots of all lines that are not empty, cell by cell and sorted within each cell: neighbours in this
    // order are mostly close to each other.
    void append_order(std::span<const PackedBox> lines, std::vector<SlotIndex>& order);

    std::size_t bytes() const noexcept;

  private:
    // Holds the ranks of a box's begin and end on three axes.
    struct alignas(32) RankedBox {
        std::array<std::int32_t, 4> begin;
        std::array<std::int32_t, 4> end;
    };
    // Holds the first and the last cell that a box reaches, on each axis of the cells.
    struct Reached {
        std::array<std::uint8_t, 2> first;
        std::array<std::uint8_t, 2> last;
    };
    struct Begin {
        std::int32_t rank;
        SlotIndex slot;
    };
    // A cell has eight rows of numbers. Each row has one number for each box in the cell, in the order of the sweep:
    // its begin and end on three axes, its slot, and two bits that say on which axes this cell is the first that the
    // box reaches.
    struct Cell {
        std::size_t offset = 0;  // offset of the first row in rows_
        std::uint32_t count = 0;
        std::uint32_t filled = 0;
        std::size_t stride() const noexcept { return count + padding; }
    };
    // Marks the boxes of a cell that may overlap box number `own`: bit i is for box number `first` + i, of eight. Hits
    // are collected and processed in bulk, so that the sweep does not wait for the memory that processing reads.
    struct Hits {
        std::uint32_t own;
        std::uint32_t first;
        std::uint32_t bits;
    };
    // Limits the number of tests that find nothing: goes_on() is false if there were many tests and few pairs. Most
    // tests find nothing if boxes are in places so far apart that all boxes of one place have equal ranks.
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
    // Each row ends with this number of padding boxes, which begin after all other boxes end: the sweep reads eight
    // boxes at once.
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
