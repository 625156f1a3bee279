// Visits the boxes of some trees in the order of the times at which a moving box may meet them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bounds/moving_box.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Visits boxes as walk_near does, by times instead of distances: each of `boxes` that may be met up to the limit is
// visited when its own lower bound (MovingBox::meets_from) is the least among the remaining boxes, equal ones by slot.
std::uint64_t walk_along(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving,
                         double limit, const std::function<double(SlotIndex)>& visit);

// Sets MovingBox::meets_from of eight boxes, bit by bit the same; infinity for empty boxes.
void meet_block(const BoxBlock& block, const MovingBox& moving, std::array<double, BoxBlock::width>& from);

}  // namespace ecods
