// Trees over boxes of any sizes, and boxes that come, go and change.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"

namespace ecods {

// One tree for each class of sizes, a factor of eight wide, and a few for newcomers, each more than three times as
// large as the next: few to look into, and a newcomer is sorted again at most a few times for each time that the number
// of newcomers quadruples.
class BoxForest {
  public:
    // A box and where it is. Only lines[slot] decides what it overlaps.
    struct Item {
        TreeItem item;
        int size_exponent;
    };
    static Item make_item(const Aabb& box, SlotIndex slot) noexcept;

    // Starts anew with these. The items are reordered. Cost: n log n.
    void build(std::span<Item> items, std::span<const PackedBox> lines);

    // Gives every slot that is in a tree the box that it has now. Cost: n.
    void refit(std::span<const PackedBox> lines);

    // The slots in the order of the trees after build(): neighbours are close to each other.
    void append_order(std::vector<SlotIndex>& order) const;

    // After build(), when the owner has put its lines in that order: slot numbers are positions in it from now on.
    void renumber();

    // A newcomer takes the place of a box that was removed, if there is one close by; the others get trees of their
    // own.
    void add(std::span<const Item> newcomers, std::span<const PackedBox> lines);
    // Of a slot that is in no tree: nothing.
    void set(SlotIndex slot, const PackedBox& line);
    void remove(SlotIndex slot);
    void prefetch(SlotIndex slot) const noexcept;  // what set() and find() of its box will look at

    // Newcomers are not sorted by size, so there should not be too many.
    std::size_t newcomer_count() const noexcept;

    // As those of BoxTree. find_pairs: all pairs that overlap, each once.
    template <class Bounds>
    std::uint64_t find(const Bounds& bounds, std::vector<SlotIndex>& found) const {
        std::uint64_t tests = 0;
        for (const BoxTree& tree : trees_) tests += tree.find(bounds, found);
        return tests;
    }
    std::uint64_t find_pairs(std::vector<std::array<SlotIndex, 2>>& found) const;

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless each slot with a line that is not empty is in exactly one place, with that box.
    void validate(std::span<const PackedBox> lines) const;

  private:
    static constexpr std::uint32_t no_tree = ~std::uint32_t{0};
    struct Place {
        std::uint32_t tree = no_tree;
        std::uint32_t position = 0;
    };

    void build_tree(std::span<TreeItem> items, std::span<const PackedBox> lines);
    bool insert(const Item& newcomer, std::span<const PackedBox> lines);

    std::vector<BoxTree> trees_;
    std::size_t class_count_ = 0;  // trees that are not for newcomers
    std::vector<int> largest_;     // size exponent, by class
    std::vector<Place> places_;    // by slot
};

}  // namespace ecods
