#include "broad_phase/boxes/box_forest.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

constexpr int exponent_count = 2048;  // number of exponents of doubles
constexpr int class_width = 3;        // in powers of two

// Returns the index of the tree for each exponent of sizes. Sizes with few boxes share the tree of the next larger
// sizes in use: small boxes in a tree of large boxes do no harm, large boxes in a tree of small boxes do.
std::array<std::uint8_t, exponent_count> choose_classes(std::span<const BoxForest::Item> items) {
    std::array<std::uint32_t, exponent_count> counts{};
    for (const auto& item : items) ++counts[static_cast<std::size_t>(item.size_exponent)];
    const std::size_t enough = items.size() / 32 + 1;
    std::array<std::uint8_t, exponent_count> classes{};
    std::uint8_t current = 0;
    std::size_t in_class = 0;
    int first = 0;  // smallest size in the class
    for (int exponent = 0; exponent < exponent_count; ++exponent) {
        if (counts[exponent] > 0) {
            if (in_class == 0) first = exponent;
            if (exponent >= first + class_width) {
                if (in_class >= enough) {
                    ++current;
                    in_class = 0;
                }
                first = exponent;
            }
            in_class += counts[exponent];
        }
        classes[exponent] = current;
    }
    return classes;
}

}  // namespace

BoxForest::Item BoxForest::make_item(const Aabb& box, SlotIndex slot) noexcept {
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, box.max[axis] - box.min[axis]);
    const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(extent) >> 52) % exponent_count;
    return {.item = tree_item(box, slot), .size_exponent = exponent};
}

void BoxForest::append_item(SlotIndex slot, std::span<const PackedBox> lines, std::vector<Item>& items) {
    if (!lines[slot].is_empty()) items.push_back(make_item(box_of(lines[slot]), slot));
}

void BoxForest::build(std::span<const PackedBox> lines) {
    std::vector<Item> items;
    items.reserve(lines.size());
    for (SlotIndex slot = 0; slot < lines.size(); ++slot) append_item(slot, lines, items);
    build(items, lines);
}

void BoxForest::build(std::span<Item> items, std::span<const PackedBox> lines) {
    trees_.clear();
    positions_.reserve(lines.size() + lines.size() / 32);  // so that adding the first box does not copy all
    positions_.assign(lines.size(), {});
    const auto classes = choose_classes(items);
    const std::size_t count = items.empty() ? 0 : std::size_t{classes[exponent_count - 1]} + 1;
    std::vector<std::vector<TreeItem>> parts(count);
    largest_.assign(count, 0);
    for (const Item& item : items) {
        const std::size_t part = classes[static_cast<std::size_t>(item.size_exponent)];
        parts[part].push_back(item.item);
        largest_[part] = std::max(largest_[part], item.size_exponent);
    }
    for (std::vector<TreeItem>& part : parts) build_tree(part, lines);
    class_count_ = trees_.size();
}

void BoxForest::build_tree(std::span<TreeItem> items, std::span<const PackedBox> lines) {
    const auto tree_index = static_cast<std::uint32_t>(trees_.size());
    BoxTree& tree = trees_.emplace_back();
    tree.build(items, lines);
    for (std::uint32_t position = 0; position < tree.size(); ++position) {
        positions_[tree.slot(position)] = {tree_index, position};
    }
}

void BoxForest::refit(std::span<const PackedBox> lines) {
    for (BoxTree& tree : trees_) tree.refit(lines);
}

bool BoxForest::insert(const Item& item, std::span<const PackedBox> lines) {
    for (std::uint32_t tree = 0; tree < class_count_; ++tree) {
        if (largest_[tree] < item.size_exponent) continue;
        Position& position = positions_[item.item.slot];
        if (!trees_[tree].insert(item.item, lines[item.item.slot], position.index)) return false;
        position.tree = tree;
        return true;
    }
    return false;
}

void BoxForest::add(std::span<const Item> items, std::span<const PackedBox> lines) {
    if (positions_.size() < lines.size()) grow_to(positions_, lines.size());
    std::vector<TreeItem> unsorted;
    for (const Item& item : items) {
        if (!insert(item, lines)) unsorted.push_back(item.item);
    }
    if (unsorted.empty()) return;
    while (trees_.size() > class_count_ && trees_.back().alive_count() <= 3 * unsorted.size()) {
        const BoxTree& tree = trees_.back();
        for (std::size_t position = 0; position < tree.size(); ++position) {
            if (tree.get(position).is_empty()) continue;
            unsorted.push_back(tree_item(box_of(lines[tree.slot(position)]), tree.slot(position)));
        }
        trees_.pop_back();
    }
    build_tree(unsorted, lines);
}

void BoxForest::set(SlotIndex slot, const PackedBox& line) {
    if (slot >= positions_.size() || positions_[slot].tree == no_tree) return;
    trees_[positions_[slot].tree].set(positions_[slot].index, line);
}

void BoxForest::prefetch(SlotIndex slot) const noexcept {
    if (slot >= positions_.size() || positions_[slot].tree == no_tree) return;
    trees_[positions_[slot].tree].prefetch(positions_[slot].index);
}

void BoxForest::remove(SlotIndex slot) {
    set(slot, {});
    if (slot < positions_.size()) positions_[slot] = {};
}

std::size_t BoxForest::unsorted_count() const noexcept {
    std::size_t count = 0;
    for (std::size_t i = class_count_; i < trees_.size(); ++i) count += trees_[i].alive_count();
    return count;
}

std::uint64_t BoxForest::find_pairs(std::vector<std::array<SlotIndex, 2>>& found) const {
    std::uint64_t tests = 0;
    for (std::size_t small = 0; small < trees_.size(); ++small) {
        for (std::size_t large = small; large < trees_.size(); ++large) {
            tests += trees_[small].join(trees_[large], found);
        }
    }
    return tests;
}

std::size_t BoxForest::bytes() const noexcept {
    std::size_t sum = bytes_of(trees_, positions_);
    for (const BoxTree& tree : trees_) sum += tree.bytes();
    return sum;
}

void BoxForest::validate(std::span<const PackedBox> lines) const {
    std::vector<int> seen(lines.size());
    for (const BoxTree& tree : trees_) {
        tree.validate();
        for (std::size_t position = 0; position < tree.size(); ++position) {
            if (tree.get(position).is_empty()) continue;
            const SlotIndex slot = tree.slot(position);
            if (slot >= lines.size() || tree.get(position) != lines[slot]) {
                throw BrokenInvariant("box forest: a tree has another box than slot " + std::to_string(slot));
            }
            ++seen[slot];
        }
    }
    for (std::size_t slot = 0; slot < lines.size(); ++slot) {
        if (seen[slot] != (lines[slot].is_empty() ? 0 : 1)) {
            throw BrokenInvariant("box forest: slot " + std::to_string(slot) + " is at " + std::to_string(seen[slot]) +
                                  " positions");
        }
        const Position position = lines[slot].is_empty() ? Position{} : positions_[slot];
        if (!lines[slot].is_empty() &&
            (position.tree >= trees_.size() || trees_[position.tree].slot(position.index) != slot)) {
            throw BrokenInvariant("box forest: the position of slot " + std::to_string(slot) + " is another's");
        }
    }
}

}  // namespace ecods
