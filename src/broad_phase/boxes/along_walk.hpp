// The boxes of some trees in the order of when a box on the move may meet them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bounds/moving_box.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/aabb.hpp"

namespace ecods {

// As walk_near, by times: each of `boxes` that may be met up to the limit is visited when its own lower bound
// (MovingBox::meets_from) is the least of what is left, equal ones by slot.
std::uint64_t walk_along(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving,
                         double limit, const std::function<double(SlotIndex)>& visit);

// MovingBox::meets_from of eight boxes, infinity for the empty ones: the same bits.
void meet_block(const BoxBlock& block, const MovingBox& moving, std::array<double, BoxBlock::width>& from);

}  // namespace ecods
