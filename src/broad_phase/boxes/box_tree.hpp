// A tree over boxes with eight children per node.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

// The index of a box in its owner's array of lines.
using SlotIndex = std::uint32_t;

constexpr SlotIndex no_slot = ~SlotIndex{0};

// A box to be put into a tree. Boxes are sorted by `center`: a good choice makes queries fast, any choice is correct,
// equal centers included. No coordinate may be NaN.
struct TreeItem {
    std::array<double, 3> center;
    SlotIndex slot;
};

TreeItem tree_item(const Aabb& box, SlotIndex slot) noexcept;

// A box that overlaps the box of one of several queries.
struct FoundBox {
    std::uint32_t query;  // number of the query
    SlotIndex slot;
};

// Scratch of a search for many queries at once: the blocks to visit on one level and on the next, with the query that
// visits each.
struct BlockVisit {
    std::uint32_t query;
    std::uint32_t block;
    std::uint32_t lanes;  // lanes that overlap, as bits
};
struct BlockVisits {
    std::vector<BlockVisit> level, next;
};

// The levels of a tree, bottom up. Level 0 has blocks of boxes, each further one blocks of bounds of the blocks below;
// the last level is one block.
using BoxLevels = std::vector<std::vector<BoxBlock>>;

// Boxes in the order of a kd-tree, eight per block; above them the bounds of eight blocks per block, and so on: the
// tree is an array for each level, without pointers. Splitting by rank keeps it balanced for any distribution:
// clusters, lines, far outliers. Boxes of mixed sizes make queries slow, since one large box makes the bounds of a
// block of small ones large: users keep a tree for each class of sizes.
//
// The walk of one tree is shared with the tree of a mesh (bvh/tree/mesh_bvh.hpp). The builders have nothing in common:
// the mesh's weighs surfaces and gives nodes any number of children, this one runs many times a second.
class BoxTree {
  public:
    // Sorts the items and builds the tree; lines[item.slot] is the box of an item. Cost: n log n.
    void build(std::span<TreeItem> items, std::span<const PackedBox> lines);

    std::size_t size() const noexcept { return slots_.size(); }        // number of positions, empty ones included
    std::size_t alive_count() const noexcept { return alive_count_; }  // number of positions that hold a box
    SlotIndex slot(std::size_t position) const {                       // slot at the position, or no_slot
        ECODS_ASSERT(position < size());
        return slots_[position];
    }

    // Sets the box at every position to the line of its slot; the order stays. Cost: n.
    void refit(std::span<const PackedBox> lines);

    // Puts a box at an empty position near its center and returns true, or returns false if none is found. Cost: that
    // of find() for a point.
    bool insert(const TreeItem& item, const PackedBox& line, std::uint32_t& position);

    // Sets a position's box; an empty box also removes the slot. Cost: a block per level, up to the first level whose
    // bounds do not change.
    void set(std::size_t position, const PackedBox& line);
    void prefetch(std::size_t position) const noexcept;
    PackedBox get(std::size_t position) const {
        ECODS_ASSERT(position / BoxBlock::width < levels_[0].size());
        return levels_[0][position / BoxBlock::width].get(position % BoxBlock::width);
    }

    // Accessors for walks in other files: level 0 holds boxes, the last level one block. Child `lane` of block b on a
    // level above 0 is block b * 8 + lane of the level below.
    std::uint32_t level_count() const noexcept { return static_cast<std::uint32_t>(levels_.size()); }
    const BoxBlock& block(std::uint32_t level, std::uint32_t index) const { return levels_[level][index]; }

    // Appends the slots of the boxes that overlap. Returns the number of box tests.
    std::uint64_t find(const BoxReach& reach, std::vector<SlotIndex>& found) const;

    // Does what find() does for many queries at once, at a lower cost for each; some hundreds are a good batch. The
    // found boxes are in no order.
    std::uint64_t find_each(std::span<const BoxReach> reaches, BlockVisits& visits, std::vector<FoundBox>& found) const;

    // Appends the slots of the boxes that doubles do not prove to be apart from a segment (SegmentBounds) or a ball
    // (BallBounds). Returns the number of box tests.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<SlotIndex>& found) const;

    // Appends the pairs of overlapping slots, one of this tree and one of `other`, which may be the same tree. Fastest
    // if the boxes of `other` are the larger ones. Returns the number of box tests.
    std::uint64_t join(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const;

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless every bound is the bound of the boxes below it.
    void validate() const;

  private:
    static constexpr std::uint32_t width = BoxBlock::width;

    bool take_hole(std::uint32_t block, SlotIndex slot, std::uint32_t& position) noexcept;

    BoxLevels levels_;
    std::vector<SlotIndex> slots_;  // by position
    std::size_t alive_count_ = 0;
};

}  // namespace ecods
