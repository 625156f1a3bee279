// Pairs in any order as an ascending list.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// Makes `list` the pairs that were found, of proxies below `proxy_end`, ascending. Cost: a few passes; sort_pairs()
// needs one for each digit of both numbers, and is for lists that are short beside the number of boxes.
void list_pairs(std::span<const std::array<SlotIndex, 2>> found, std::size_t proxy_end, ProxyPairs& list);

}  // namespace ecods
