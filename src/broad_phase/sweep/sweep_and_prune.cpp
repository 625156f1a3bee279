#include "broad_phase/sweep/sweep_and_prune.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "base/bytes_of.hpp"
#include "broad_phase/sweep/endpoints_sort.hpp"
#include "broad_phase/sweep/find_pairs.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

// Removes the ends of the removed proxies from the list. Cost: one pass.
void remove_ends(EndpointList& ends, const ProxyTable& table) {
    std::erase_if(ends, [&](const Endpoint& end) { return table.is_removed(end.proxy()); });
}

// Merges the ends of the added proxies into a sorted list. Cost: sorting these ends, and one pass over the list.
void insert_ends(EndpointList& ends, int axis, std::span<const ProxyIndex> added, const BoxHistory& boxes) {
    const auto old_count = static_cast<std::ptrdiff_t>(ends.size());
    for (const ProxyIndex proxy : added) {
        ends.push_back(min_end(boxes.now(proxy), proxy, axis));
        ends.push_back(max_end(boxes.now(proxy), proxy, axis));
    }
    std::sort(ends.begin() + old_count, ends.end());
    std::inplace_merge(ends.begin(), ends.begin() + old_count, ends.end());
}

}  // namespace

void SweepAndPrune::build(const ProxyTable& table, BroadPhaseCounts&) {
    const std::vector<ProxyIndex> present = table.present_proxies();
    boxes_.advance(present, table);
    boxes_.settle(present);
    for (int axis = 0; axis < 3; ++axis) insert_ends(axes_[axis], axis, present, boxes_);
}

void SweepAndPrune::reserve(std::size_t count) {
    boxes_.reserve(count);
    for (EndpointList& ends : axes_) ends.reserve(2 * count);
}

void SweepAndPrune::update(const FindingUpdate& update) {
    const auto& [table, changes, keeper, events, counts] = update;
    if (!changes.removed.empty()) {
        keeper.append_removed(table, changes, events.ended);
        for (EndpointList& ends : axes_) remove_ends(ends, table);
    }
    boxes_.advance(changes.moved, table);
    boxes_.advance(changes.added, table);
    const bool tracked = sort_axes(update);
    if (!changes.added.empty()) {
        for (int axis = 0; axis < 3; ++axis) insert_ends(axes_[axis], axis, changes.added, boxes_);
    }
    if (tracked) {
        if (!changes.added.empty()) counts.box_tests += find_pairs_of(changes.added, table, events.began);
        normalise(events.began);
        normalise(events.ended);
    } else {
        update_from_scratch(update);
    }
    boxes_.settle(changes.moved);
    boxes_.settle(changes.added);
}

// Sorts the three lists and appends events to update.events. Returns false if events are missing because the boxes
// moved too far; the lists are sorted even then.
bool SweepAndPrune::sort_axes(const FindingUpdate& update) {
    const std::span<const ProxyIndex> moved = update.changes.moved;
    if (moved.empty()) return true;
    // When boxes jump, each end passes a large part of a list, and starting from scratch is cheaper: sorting the lists
    // and finding the pairs from scratch cost about as much as this number of swaps for each end of one list.
    constexpr std::uint64_t swaps_per_end_max = 128;
    SortState state{.boxes = boxes_,
                    .began = update.events.began,
                    .ended = update.events.ended,
                    .swaps_max = swaps_per_end_max * axes_[0].size(),
                    .positions = std::move(positions_)};
    bool tracked = true;
    for (int axis = 0; axis < 3 && tracked; ++axis) {
        tracked = sort_axis(axes_[axis], axis, moved, state);
    }
    update.counts.swaps += state.swaps;
    update.counts.box_tests += state.box_tests;
    positions_ = std::move(state.positions);
    if (!tracked) {
        for (int axis = 0; axis < 3; ++axis) sort_axis_from_scratch(axes_[axis], axis, boxes_);
    }
    return tracked;
}

std::size_t SweepAndPrune::bytes() const noexcept {
    return boxes_.bytes() + bytes_of(axes_[0], axes_[1], axes_[2], positions_);
}

namespace {

void validate_axis(const EndpointList& ends, int axis, const ProxyTable& table) {
    const std::string name = "sweep and prune, axis " + std::to_string(axis) + ": ";
    if (ends.size() != 2 * table.size()) throw BrokenInvariant(name + "the number of ends is wrong");
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const Endpoint& end = ends[i];
        const std::string whose = name + "an end of proxy " + std::to_string(end.proxy());
        // Together with the number of ends, strict order shows that each present box has its two ends, once each.
        if (i > 0 && !(ends[i - 1] < end)) throw BrokenInvariant(whose + " is out of order");
        if (!table.is_present(end.proxy())) throw BrokenInvariant(whose + ", which is not present");
        const KeyBox box = key_box(table.box(end.proxy()));
        if (end.key != (end.is_max() ? box.max[axis] : box.min[axis])) {
            throw BrokenInvariant(whose + " is not where its box ends");
        }
    }
}

}  // namespace

void SweepAndPrune::validate(const ProxyTable& table) const {
    for (int axis = 0; axis < 3; ++axis) validate_axis(axes_[axis], axis, table);
    table.for_each([&](ProxyIndex proxy, const Aabb& box) {
        if (boxes_.now(proxy) != key_box(box) || boxes_.before(proxy) != key_box(box)) {
            throw BrokenInvariant("sweep and prune: the box of proxy " + std::to_string(proxy) + " is another's");
        }
    });
}

}  // namespace ecods
