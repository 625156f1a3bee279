// Defines a forest: trees over boxes of all sizes, which may be added, removed and changed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"

namespace ecods {

// Holds one tree for each class of sizes, a factor of eight wide, and a few unsorted trees, which hold boxes of any
// size that were added later. Each unsorted tree is more than three times as large as the next one, so there are few of
// them to search. While the number of boxes in unsorted trees quadruples, a box moves only a few times from one of
// these trees to another.
class BoxForest {
  public:
    // Describes a box to be put into a tree: its slot, center and size. Center and size only decide where in the forest
    // the box is put; lines[slot] decides which boxes it overlaps.
    struct Item {
        TreeItem item;
        int size_exponent;
    };
    static Item make_item(const Aabb& box, SlotIndex slot) noexcept;

    // Appends the item of a slot to `items`, unless lines[slot] is empty.
    static void append_item(SlotIndex slot, std::span<const PackedBox> lines, std::vector<Item>& items);

    // Builds the forest from `items`, or from all lines that are not empty. Cost: n log n.
    void build(std::span<Item> items, std::span<const PackedBox> lines);
    void build(std::span<const PackedBox> lines);

    // Sets the box of every slot that is in a tree to lines[slot]. Cost: n.
    void refit(std::span<const PackedBox> lines);

    // Adds boxes to the forest. If the tree for the size of a box has the position of a removed box near it, the box
    // takes that position. The other boxes get an unsorted tree.
    void add(std::span<const Item> items, std::span<const PackedBox> lines);

    // Sets the box of a slot, or removes the slot. Does nothing to a slot that is in no tree.
    void set(SlotIndex slot, const PackedBox& line);
    void remove(SlotIndex slot);

    // Prefetches the memory that set() of this slot, and find() of its box, will read.
    void prefetch(SlotIndex slot) const noexcept;

    // Returns the number of boxes in unsorted trees. As this number grows, searches slow down: then call build().
    std::size_t unsorted_count() const noexcept;

    // Calls BoxTree::find for all trees. Returns the number of box tests.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<SlotIndex>& found) const {
        std::uint64_t tests = 0;
        for (const BoxTree& tree : trees_) tests += tree.find(bounds, found);
        return tests;
    }

    // Calls BoxTree::find_each for all trees. Returns the number of box tests.
    std::uint64_t find_each(std::span<const BoxReach> reaches, BlockVisits& visits,
                            std::vector<FoundBox>& found) const {
        std::uint64_t tests = 0;
        for (const BoxTree& tree : trees_) tests += tree.find_each(reaches, visits, found);
        return tests;
    }

    // Appends all pairs of slots whose boxes overlap, each once. Returns the number of box tests.
    std::uint64_t find_pairs(std::vector<std::array<SlotIndex, 2>>& found) const;

    std::span<const BoxTree> trees() const noexcept { return trees_; }

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless each slot with a line that is not empty is at exactly one position, with that box.
    void validate(std::span<const PackedBox> lines) const;

  private:
    static constexpr std::uint32_t no_tree = ~std::uint32_t{0};
    struct Position {
        std::uint32_t tree = no_tree;
        std::uint32_t index = 0;  // index in the tree
    };

    void build_tree(std::span<TreeItem> items, std::span<const PackedBox> lines);
    bool insert(const Item& item, std::span<const PackedBox> lines);

    std::vector<BoxTree> trees_;
    std::size_t class_count_ = 0;      // number of trees before the unsorted ones
    std::vector<int> largest_;         // largest size exponent, by class
    std::vector<Position> positions_;  // by slot
};

}  // namespace ecods
