#include "broad_phase/sweep_and_prune.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "broad_phase/edit_axis.hpp"
#include "broad_phase/sort_axis.hpp"
#include "broad_phase/validate_pairs.hpp"
#include "ecods/error.hpp"

namespace ecods {

void SweepAndPrune::update() {
    ++counts_.updates;
    began_.clear();
    ended_.clear();
    const ProxyChanges& changes = table_.collect();
    counts_.moved += changes.added.size() + changes.moved.size();
    if (!changes.empty()) apply(changes);
    table_.settle();
}

void SweepAndPrune::apply(const ProxyChanges& changes) {
    if (!changes.removed.empty()) {
        end_removed(pairs_, table_, ended_);
        for (EndpointList& ends : axes_) remove_ends(ends, table_);
    }
    const auto removed_count = static_cast<std::ptrdiff_t>(ended_.size());
    const bool tracked = sort_axes(changes);
    if (!changes.added.empty()) {
        for (int axis = 0; axis < 3; ++axis) insert_ends(axes_[axis], axis, changes.added, table_);
    }
    if (tracked) {
        if (!changes.added.empty()) {
            sweep_axes(SweepScope::pairs_of_added, began_);
        }
        normalise(began_);
        normalise(ended_);
        apply_events(ended_, began_, pairs_);
    } else {
        ProxyPairs found;
        sweep_axes(SweepScope::all_pairs, found);
        std::sort(found.begin(), found.end());
        began_.clear();
        ended_.erase(ended_.begin() + removed_count, ended_.end());
        replace_pairs(found, pairs_, began_, ended_);
    }
}

void SweepAndPrune::sweep_axes(SweepScope scope, ProxyPairs& found) {
    const SweepAxis best = choose_sweep_axis(axes_);
    axis_overlaps_ = best.overlaps;
    swaps_when_counted_ = counts_.swaps;
    counts_.box_tests += sweep(axes_[best.axis], best.axis, table_, scope, found);
}

// When boxes jump, ends pass a large part of a list each, and starting from scratch is cheaper. That is sorting the
// lists, for about 64 swaps an end of one list, and a sweep, for about a swap a pair that overlaps on its axis. That
// number drifts as boxes move: it is counted again once swaps have paid for counting. Counts decide, never clocks.
std::uint64_t SweepAndPrune::swaps_max() {
    const std::uint64_t sorting = 64 * axes_[0].size();
    if (counts_.swaps - swaps_when_counted_ > sorting) {
        axis_overlaps_ = choose_sweep_axis(axes_).overlaps;
        swaps_when_counted_ = counts_.swaps;
    }
    return sorting + axis_overlaps_;
}

// Returns whether all changes of pairs were seen. If not, the lists are sorted nevertheless.
bool SweepAndPrune::sort_axes(const ProxyChanges& changes) {
    if (changes.moved.empty()) return true;
    SortState state{.table = table_,
                    .began = began_,
                    .ended = ended_,
                    .swaps_max = swaps_max(),
                    .positions = std::move(positions_)};
    bool tracked = true;
    for (int axis = 0; axis < 3 && tracked; ++axis) {
        tracked = sort_axis(axes_[axis], axis, changes.moved, state);
    }
    counts_.swaps += state.swaps;
    counts_.box_tests += state.box_tests;
    positions_ = std::move(state.positions);
    if (!tracked) {
        for (int axis = 0; axis < 3; ++axis) sort_axis_anew(axes_[axis], axis, table_);
    }
    return tracked;
}

namespace {

void validate_axis(const EndpointList& ends, int axis, const ProxyTable& table) {
    const std::string name = "sweep and prune, axis " + std::to_string(axis) + ": ";
    if (ends.size() != 2 * table.size()) throw BrokenInvariant(name + "the number of ends is wrong");
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const Endpoint& end = ends[i];
        const std::string whose = name + "an end of proxy " + std::to_string(end.proxy());
        // Together with the number of ends: each box present has its two ends, once.
        if (i > 0 && !(ends[i - 1] < end)) throw BrokenInvariant(whose + " is out of order");
        if (!table.is_present(end.proxy())) throw BrokenInvariant(whose + ", which is not present");
        const KeyBox& box = table.now(end.proxy());
        if (end.key != (end.is_max() ? box.max[axis] : box.min[axis])) {
            throw BrokenInvariant(whose + " is not where its box ends");
        }
    }
}

}  // namespace

void SweepAndPrune::validate() const {
    for (int axis = 0; axis < 3; ++axis) validate_axis(axes_[axis], axis, table_);
    validate_pairs(table_, pairs_, began_, ended_);
}

}  // namespace ecods
