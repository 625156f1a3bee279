// Visits the boxes of some trees in the order of the times at which a moving box may meet them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bounds/moving_box.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Visits the boxes that `moving` may meet up to the time `limit`, in ascending order of a lower bound of that time
// (MovingBox::meets_from); boxes with equal bounds in the order of their slots. `boxes` has the boxes by slot; the
// trees' boxes contain them. Each visit returns a new limit, which counts if it is smaller. Returns the number of box
// tests.
std::uint64_t walk_along(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving,
                         double limit, const std::function<double(SlotIndex)>& visit);

// Sets from[i] to MovingBox::meets_from of box i of the block, with the same bits; infinity for an empty box.
void meet_block(const BoxBlock& block, const MovingBox& moving, std::array<double, BoxBlock::width>& from);

}  // namespace ecods
