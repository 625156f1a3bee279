// The boxes of some trees, and their pairs, in the order of how far they are from each other at least.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/aabb.hpp"

namespace ecods {

// Best first (Hjaltason and Samet, Distance Browsing in Spatial Databases, 1999; for pairs the same authors,
// Incremental Distance Join Algorithms for Spatial Databases, 1998). `boxes`, by slot, are what the trees' boxes
// contain; each is visited when its own lower bound (distance_below) is the least of what is left, equal ones by slot.
// A visit returns the limit from then on, which may shrink: what is proven to be further apart is not visited. Return
// the number of box tests.
std::uint64_t walk_near(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const Aabb& box, double limit,
                        const std::function<double(SlotIndex)>& visit);
std::uint64_t walk_near_pairs(std::span<const BoxTree> trees, std::span<const Aabb> boxes, double limit,
                              const std::function<double(SlotIndex, SlotIndex)>& visit);

}  // namespace ecods
