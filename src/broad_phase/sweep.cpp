#include "broad_phase/sweep.hpp"

#include <cstddef>
#include <vector>

namespace ecods {
namespace {

struct Swept {
    KeyBox box;
    ProxyIndex proxy;
    bool is_added;
};

// Those of others, from `first` on, that begin on the axis before `one` ends, and overlap it.
std::uint64_t scan(const Swept& one, const std::vector<Swept>& others, std::size_t first, int axis, ProxyPairs& found) {
    std::size_t i = first;
    for (; i < others.size() && others[i].box.min[axis] <= one.box.max[axis]; ++i) {
        if (overlap(one.box, others[i].box)) found.push_back(ordered_pair(one.proxy, others[i].proxy));
    }
    return i - first;
}

std::uint64_t count_overlaps(const EndpointList& ends) {
    std::uint64_t overlaps = 0;
    std::uint64_t open = 0;  // boxes that began and did not end
    for (const Endpoint& end : ends) {
        if (end.is_max()) {
            --open;
        } else {
            overlaps += open++;
        }
    }
    return overlaps;
}

}  // namespace

SweepAxis choose_sweep_axis(const std::array<EndpointList, 3>& axes) {
    SweepAxis best{.axis = 0, .overlaps = count_overlaps(axes[0])};
    for (int axis = 1; axis < 3; ++axis) {
        const std::uint64_t overlaps = count_overlaps(axes[axis]);
        if (overlaps < best.overlaps) best = {.axis = axis, .overlaps = overlaps};
    }
    return best;
}

std::uint64_t sweep(const EndpointList& ends, int axis, const ProxyTable& table, SweepScope scope, ProxyPairs& found) {
    std::vector<Swept> all;  // by their minimum
    std::vector<Swept> added;
    all.reserve(table.size());
    for (const Endpoint& end : ends) {
        if (end.is_max()) continue;
        const ProxyIndex proxy = end.proxy();
        const bool is_added = scope == SweepScope::all_pairs || table.is_added(proxy);
        all.push_back({table.now(proxy), proxy, is_added});
        if (is_added && scope == SweepScope::pairs_of_added) added.push_back(all.back());
    }

    // Each pair is found by the one of the two that begins first. One that was here before looks at added ones only.
    std::uint64_t tests = 0;
    std::size_t next_added = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].is_added) {
            ++next_added;
            tests += scan(all[i], all, i + 1, axis, found);
        } else {
            tests += scan(all[i], added, next_added, axis, found);
        }
    }
    return tests;
}

}  // namespace ecods
