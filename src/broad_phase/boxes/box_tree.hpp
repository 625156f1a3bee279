// A tree over boxes, eight children a node.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

// Names a box in its owner's array of lines.
using SlotIndex = std::uint32_t;

constexpr SlotIndex no_slot = ~SlotIndex{0};

// A box to be put into a tree. The center is where it is sorted to: a good choice makes queries fast, and any other,
// equal ones included, is as right. No coordinate may be NaN.
struct TreeItem {
    std::array<double, 3> center;
    SlotIndex slot;
};

TreeItem tree_item(const Aabb& box, SlotIndex slot) noexcept;

// Boxes in the order of a kd-tree, eight in a block, the bounds of eight blocks in a block, and so on, so that the
// tree is its levels and no pointers. Splitting by rank makes it hold for any distribution: clusters, lines, far
// outliers. It does not hold for mixed sizes: one large box in each block of small ones spoils it. Its users keep a
// tree for each class of sizes.
class BoxTree {
  public:
    // Orders the items. lines[item.slot] is the box. Cost: n log n.
    void build(std::span<TreeItem> items, std::span<const PackedBox> lines);

    std::size_t size() const noexcept { return slots_.size(); }              // positions, of which some may be empty
    std::size_t alive_count() const noexcept { return alive_count_; }        // those that are not
    SlotIndex slot(std::size_t position) const { return slots_[position]; }  // or no_slot

    // Gives every position that has a slot the box that it has now; the order stays. Cost: n.
    void refit(std::span<const PackedBox> lines);

    // Numbers the positions base, base + 1, ...: their owner has put its lines in the order of the tree.
    void renumber(SlotIndex base);

    // Puts a box where another was taken out, close to where it belongs. Returns false when there is no such place.
    // Cost: as find() of a point.
    bool insert(const TreeItem& item, const PackedBox& line, std::uint32_t& position);

    // Gives a position another box; an empty one takes its slot out for good. Cost: a block a level, less where bounds
    // stay.
    void set(std::size_t position, const PackedBox& line);
    void prefetch(std::size_t position) const noexcept;
    PackedBox get(std::size_t position) const {
        return levels_[0][position / BoxBlock::width].get(position % BoxBlock::width);
    }

    // Appends the slots of the boxes that overlap. Returns the number of box tests.
    std::uint64_t find(const BoxReach& reach, std::vector<SlotIndex>& found) const;

    // Appends the slots of the boxes that doubles do not prove to be apart from a segment (SegmentBounds) or a ball
    // (BallBounds). Returns the number of box tests.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<SlotIndex>& found) const;

    // Appends the pairs of slots that overlap, one of this tree, the other of `other`, which may be the same tree. Best
    // when the other's boxes are not the smaller ones. Returns the number of box tests.
    std::uint64_t join(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const;

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless every bound is the bound of what lies below it.
    void validate() const;

  private:
    static constexpr std::uint32_t width = BoxBlock::width;

    // A block of bounds, and some of its lanes.
    struct Parent {
        std::uint32_t block;
        std::uint32_t children;
    };

    bool take_hole(std::uint32_t block, SlotIndex slot, std::uint32_t& position) noexcept;
    std::uint64_t find_wide(const BoxReach& reach, std::vector<SlotIndex>& found) const;
    std::uint64_t join_wide(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const;
    std::uint64_t find_parents(const BoxReach& reach, std::uint32_t first, std::vector<Parent>& found) const;

    std::vector<std::vector<BoxBlock>> levels_;  // the boxes first, one block last
    std::vector<SlotIndex> slots_;               // by position
    std::size_t alive_count_ = 0;
};

}  // namespace ecods
