// Visits the boxes of some trees that are near a box, or near each other, in ascending order of a lower bound of the
// distance.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Visit boxes or pairs of boxes by best-first search (Hjaltason and Samet, Distance Browsing in Spatial Databases,
// 1999; for pairs the same authors, Incremental Distance Join Algorithms for Spatial Databases, 1998). `boxes` has the
// boxes by slot; the trees' boxes contain them. A box or a pair is visited when its lower bound (distance_below) is the
// least among all that remain; if bounds are equal, the order is the order of the slots. Each visit returns a new
// limit, which counts if it is smaller; boxes and pairs that are proven to be farther apart are not visited. Return the
// number of box tests.
std::uint64_t walk_near(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const Aabb& box, double limit,
                        const std::function<double(SlotIndex)>& visit);
std::uint64_t walk_near_pairs(std::span<const BoxTree> trees, std::span<const Aabb> boxes, double limit,
                              const std::function<double(SlotIndex, SlotIndex)>& visit);

}  // namespace ecods
