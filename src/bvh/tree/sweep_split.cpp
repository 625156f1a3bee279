#include "bvh/tree/sweep_split.hpp"

#include <algorithm>

namespace ecods {
namespace {

// Returns an integer with the same order as the float; both zeros have the same key. The integer is computed from the
// bits, so that the order does not depend on the floating-point environment.
std::uint32_t order_key(float x) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    constexpr std::uint32_t sign = std::uint32_t{1} << 31;
    if (bits == sign) return sign;
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

}  // namespace

void SweepSplit::begin(std::span<PrimitiveRef> items) {
    items_ = items;
    std::copy(items.begin(), items.end(), copies_.begin());
    const auto end = copies_.begin() + static_cast<std::ptrdiff_t>(items.size());
    const auto is_less = [](const PrimitiveRef& a, const PrimitiveRef& b) { return a.triangle() < b.triangle(); };
    if (!std::is_sorted(copies_.begin(), end, is_less)) std::sort(copies_.begin(), end, is_less);
    for (std::size_t axis = 0; axis < 3; ++axis) sort(axis);
}

// Sorts indices into copies_ by the middles of the boxes on an axis. Equal middles are sorted by triangle, which is the
// order of copies_.
void SweepSplit::sort(std::size_t axis) {
    std::array<std::uint64_t, size_max> keys;
    const std::size_t count = items_.size();
    for (std::size_t i = 0; i < count; ++i)
        keys[i] = std::uint64_t{order_key(copies_[i].middle()[static_cast<int>(axis)])} << 32 | i;
    std::sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) orders_[axis][i] = static_cast<std::uint8_t>(keys[i]);
}

// Tries every cut of the part [begin, end) in its order along an axis, and sets `best` to the cheapest cut if it is
// cheaper than `best`.
void SweepSplit::sweep(std::uint32_t begin, std::uint32_t end, std::size_t axis, Cut& best) const noexcept {
    const Order& order = orders_[axis];
    const std::uint32_t count = end - begin;
    std::array<float, size_max + 1> left_cost;
    FrameBox box;
    for (std::uint32_t i = 0; i < count; ++i) {
        box.include(copies_[order[begin + i]].box);
        left_cost[i + 1] = box.surface() * leaf_visits(i + 1);
    }
    box = {};
    for (std::uint32_t i = count - 1; i > 0; --i) {
        box.include(copies_[order[begin + i]].box);
        const float cost = left_cost[i] + box.surface() * leaf_visits(count - i);
        // If all cuts of a flat part cost zero, the cut in the middle is taken.
        if (cost < best.cost || (cost == best.cost && best.cost == 0 && i >= count / 2)) best = {cost, i, axis};
    }
}

// Partitions a part of an order: indices in `first_side` (bit i is index i) come before the others. Each side keeps its
// order.
void SweepSplit::part(Order& order, std::uint32_t begin, std::uint32_t end, std::uint64_t first_side) noexcept {
    Order others;
    std::uint32_t kept = begin, moved = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint8_t place = order[i];
        const bool is_first = first_side >> place & 1;
        order[kept] = place;
        others[moved] = place;
        kept += is_first ? 1 : 0;
        moved += is_first ? 0 : 1;
    }
    std::copy_n(others.begin(), moved, order.begin() + kept);
}

void SweepSplit::put_back(std::uint32_t begin, std::uint32_t end) {
    if (end - begin > tree_width) return;
    for (std::uint32_t i = begin; i < end; ++i) items_[i] = copies_[orders_[axis_][i]];
}

std::uint32_t SweepSplit::split(std::uint32_t begin, std::uint32_t end) {
    Cut best;
    best.size = (end - begin) / 2;
    for (std::size_t axis = 0; axis < 3; ++axis) sweep(begin, end, axis, best);
    axis_ = best.axis;
    const std::uint32_t middle = begin + best.size;
    std::uint64_t first_side = 0;
    for (std::uint32_t i = begin; i < middle; ++i) first_side |= std::uint64_t{1} << orders_[axis_][i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis != axis_) part(orders_[axis], begin, end, first_side);
    }
    put_back(begin, middle);
    put_back(middle, end);
    return middle;
}

FrameBox SweepSplit::box_of(std::uint32_t begin, std::uint32_t end) const noexcept {
    FrameBox box;
    for (std::uint32_t i = begin; i < end; ++i) box.include(copies_[orders_[axis_][i]].box);
    return box;
}

}  // namespace ecods
