#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "base/bytes_of.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

// Returns the axis on which the centers have the largest range. Ranges may overflow to infinity.
int choose_axis(std::span<const TreeItem> items) {
    std::array<double, 3> min = items[0].center;
    std::array<double, 3> max = min;
    for (const TreeItem& item : items) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], item.center[axis]);
            max[axis] = std::max(max[axis], item.center[axis]);
        }
    }
    int best = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (max[axis] - min[axis] > max[best] - min[best]) best = axis;
    }
    return best;
}

// Sorts the items into the order of the tree: splits them by rank, down to single blocks. The number of blocks in the
// first part of each split is a power of two, so that the eight blocks of a parent are the result of three splits.
void order(std::span<TreeItem> items) {
    std::array<std::span<TreeItem>, 32> stack;  // second parts, at most one for each halving of 2^32 items
    std::size_t depth = 0;
    for (;;) {
        if (items.size() <= BoxBlock::width) {
            if (depth == 0) return;
            items = stack[--depth];
            continue;
        }
        const int axis = choose_axis(items);
        const std::size_t half = std::bit_floor((items.size() - 1) / BoxBlock::width) * BoxBlock::width;
        std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                         [axis](const TreeItem& a, const TreeItem& b) { return a.center[axis] < b.center[axis]; });
        stack[depth++] = items.subspan(half);
        items = items.first(half);
    }
}

}  // namespace

TreeItem tree_item(const Aabb& box, SlotIndex slot) noexcept {
    TreeItem item{.center = {}, .slot = slot};
    for (int axis = 0; axis < 3; ++axis) {
        const double center = 0.5 * box.min[axis] + 0.5 * box.max[axis];
        item.center[axis] = std::abs(center) <= std::numeric_limits<double>::max() ? center : 0;
    }
    return item;
}

void BoxTree::build(std::span<TreeItem> items, std::span<const PackedBox> lines) {
    order(items);
    slots_.resize(items.size());
    alive_count_ = items.size();
    for (std::size_t position = 0; position < items.size(); ++position) slots_[position] = items[position].slot;
    levels_.clear();
    std::size_t count = items.size();
    do {
        count = (count + width - 1) / width;
        levels_.emplace_back(count);
    } while (count > 1);
    refit(lines);
}

void BoxTree::refit(std::span<const PackedBox> lines) {
    for (std::size_t position = 0; position < slots_.size(); ++position) {
        if (slots_[position] == no_slot) continue;
        levels_[0][position / width].set(position % width, lines[slots_[position]]);
    }
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        for (std::size_t i = 0; i < levels_[level - 1].size(); ++i) {
            levels_[level][i / width].set(i % width, levels_[level - 1][i].bounds());
        }
    }
}

void BoxTree::set(std::size_t position, const PackedBox& line) {
    ECODS_ASSERT(position < size());
    ECODS_ASSERT(line.is_empty() || slots_[position] != no_slot);
    if (line.is_empty() && slots_[position] != no_slot) {
        slots_[position] = no_slot;
        --alive_count_;
    }
    PackedBox bounds = line;
    for (std::vector<BoxBlock>& level : levels_) {
        BoxBlock& block = level[position / width];
        if (block.has(position % width, bounds)) return;
        block.set(position % width, bounds);
        bounds = block.bounds();
        position /= width;
    }
}

std::size_t BoxTree::bytes() const noexcept {
    std::size_t sum = bytes_of(levels_, slots_);
    for (const auto& level : levels_) sum += bytes_of(level);
    return sum;
}

void BoxTree::validate() const {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw BrokenInvariant(std::string("box tree: ") + what);
    };
    std::size_t alive_count = 0;
    for (std::size_t i = 0; i < levels_[0].size() * width; ++i) {
        const bool is_empty = get(i).is_empty();
        require(is_empty == (i >= size() || slots_[i] == no_slot), "there is a box without a slot, or the reverse");
        alive_count += is_empty ? 0 : 1;
    }
    require(alive_count == alive_count_, "the number of boxes is wrong");
    require(levels_.back().size() <= 1, "there is more than one root");
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        require((levels_[level - 1].size() + width - 1) / width == levels_[level].size(), "a level has a wrong size");
        for (std::size_t i = 0; i < levels_[level].size() * width; ++i) {
            PackedBox expected;
            if (i < levels_[level - 1].size()) {
                for (std::size_t k = 0; k < width; ++k) enlarge(expected, levels_[level - 1][i].get(k));
            }
            require(levels_[level][i / width].get(i % width) == expected, "bounds are not those of what they bound");
        }
    }
}

}  // namespace ecods
