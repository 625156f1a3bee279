#include "world/way_box.hpp"

#include "base/double_key.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/cast/turn_boxes.hpp"
#include "query/cast/way_boxes.hpp"

namespace ecods {
namespace {

// Returns a box that contains every point of a body while it moves between two poses with these boxes. Each point moves
// on a straight line, so each of its coordinates stays between its values at the two ends.
Aabb box_of_ends(const Aabb& from, const Aabb& to) {
    Aabb box = from;
    for (int axis = 0; axis < 3; ++axis) {
        if (key_of(to.min[axis]) < key_of(box.min[axis])) box.min[axis] = to.min[axis];
        if (key_of(to.max[axis]) > key_of(box.max[axis])) box.max[axis] = to.max[axis];
    }
    return box;
}

}  // namespace

Aabb box_of_way(const Shape& shape, const Pose& start, const Aabb& from, const Motion& motion, BodyId body,
                const ListIndex& index) {
    const Pose* const end = straight_end(start, motion);
    if (end == &start) return from;
    if (end != nullptr) return box_of_ends(from, box_for(shape, *end, body, index));
    if (const auto* const nodes = nodes_of(motion)) return WayBoxes(from, *nodes).whole();
    return TurnBoxes(from, turn_of(motion)).whole();
}

}  // namespace ecods
