// Defines a tree over boxes with eight children per node.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

// Names a box by its index in the owner's array of lines (packed boxes).
using SlotIndex = std::uint32_t;

constexpr SlotIndex no_slot = ~SlotIndex{0};

// Describes a box to be put into a tree. `center` decides its place there: any center is correct, also one that several
// boxes share, and a good one makes queries fast. No coordinate may be NaN.
struct TreeItem {
    std::array<double, 3> center;
    SlotIndex slot;
};

TreeItem tree_item(const Aabb& box, SlotIndex slot) noexcept;

// Names a box that overlaps the box of one of several queries.
struct FoundBox {
    std::uint32_t query;  // number of the query
    SlotIndex slot;
};

// Describes the visit of a block by one of several queries.
struct BlockVisit {
    std::uint32_t query;
    std::uint32_t block;
    std::uint32_t lanes;  // lanes that overlap, as bits
};
// Holds scratch of find_each(): the visits on one level and on the next.
struct BlockVisits {
    std::vector<BlockVisit> level, next;
};

// Holds the levels of a tree, bottom up. Level 0 has blocks of boxes. Each further level has blocks of bounds, one
// bound for each block of the level before. The last level is one block.
using BoxLevels = std::vector<std::vector<BoxBlock>>;

// Keeps boxes in the order of a kd-tree, eight per block, and above them the bounds of eight blocks per block, and so
// on: the tree is an array for each level, without pointers. Splitting by rank keeps the tree balanced for any
// distribution: clusters, lines, far outliers. Boxes of mixed sizes make queries slow, since one large box makes the
// bounds of a block of small boxes large: users keep a tree for each class of sizes.
//
// The tree shares its walk, walk_one(), with the tree of a mesh (bvh/tree/mesh_bvh.hpp). The builders of the two have
// nothing in common: the builder of a mesh's tree weighs surfaces and gives nodes any number of children, and the
// builder here runs many times a second.
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

    // Sets the box at every position to the line of its slot, and keeps the order of the slots. Cost: n.
    void refit(std::span<const PackedBox> lines);

    // Puts a box at an empty position near its center, sets `position` and returns true, or returns false if it finds
    // no empty position there. Costs as much as find() for a point.
    bool insert(const TreeItem& item, const PackedBox& line, std::uint32_t& position);

    // Sets the box at a position; an empty box also removes the slot. Cost: a block per level, up to the first level
    // whose bounds do not change.
    void set(std::size_t position, const PackedBox& line);
    void prefetch(std::size_t position) const noexcept;
    PackedBox get(std::size_t position) const {
        ECODS_ASSERT(position / BoxBlock::width < levels_[0].size());
        return levels_[0][position / BoxBlock::width].get(position % BoxBlock::width);
    }

    // The next functions give walks in other files access to the blocks. Level 0 holds boxes; the last level is one
    // block. Child `lane` of block b on a level above 0 is block b * 8 + lane of the level below.
    std::uint32_t level_count() const noexcept { return static_cast<std::uint32_t>(levels_.size()); }
    const BoxBlock& block(std::uint32_t level, std::uint32_t index) const { return levels_[level][index]; }

    // Appends to `found` the slots of the boxes that overlap the box of `reach`. Returns the number of box tests.
    std::uint64_t find(const BoxReach& reach, std::vector<SlotIndex>& found) const;

    // Appends to `found` the boxes that overlap each of many query boxes, in no order. Costs less per query than
    // find(); some hundreds of queries are a good batch. `visits` is scratch. Returns the number of box tests.
    std::uint64_t find_each(std::span<const BoxReach> reaches, BlockVisits& visits, std::vector<FoundBox>& found) const;

    // Appends to `found` the slots of the boxes that a test in doubles does not prove to be apart from a segment
    // (SegmentBounds) or a ball (BallBounds). Returns the number of box tests.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<SlotIndex>& found) const;

    // Appends the pairs of slots whose boxes overlap, one slot of this tree and one of `other`, which may be this tree.
    // Fastest if the boxes of `other` are the larger ones. Returns the number of box tests.
    std::uint64_t join(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const;

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless each bound on a higher level is the bound of the boxes below it.
    void validate() const;

  private:
    static constexpr std::uint32_t width = BoxBlock::width;

    bool take_hole(std::uint32_t block, SlotIndex slot, std::uint32_t& position) noexcept;

    BoxLevels levels_;
    std::vector<SlotIndex> slots_;  // by position
    std::size_t alive_count_ = 0;
};

}  // namespace ecods
