#include "broad_phase/sweep/endpoints_edit.hpp"

#include <algorithm>
#include <cstddef>

namespace ecods {

void remove_ends(EndpointList& ends, const ProxyTable& table) {
    std::erase_if(ends, [&](const Endpoint& end) { return table.is_removed(end.proxy()); });
}

void insert_ends(EndpointList& ends, int axis, std::span<const ProxyIndex> added, const BoxHistory& boxes) {
    const auto old_count = static_cast<std::ptrdiff_t>(ends.size());
    for (const ProxyIndex proxy : added) {
        ends.push_back(min_end(boxes.now(proxy), proxy, axis));
        ends.push_back(max_end(boxes.now(proxy), proxy, axis));
    }
    std::sort(ends.begin() + old_count, ends.end());
    std::inplace_merge(ends.begin(), ends.begin() + old_count, ends.end());
}

}  // namespace ecods
