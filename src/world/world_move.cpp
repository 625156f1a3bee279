#include <vector>

#include "geometry/same_bits.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_pose(BodyId body, const Pose& pose) {
    Impl& w = impl();
    const ProxyIndex proxy = w.bodies.require(body);
    require_valid(pose, body);
    Slot& slot = w.bodies[proxy];
    if (same_bits(slot.pose, pose)) return;
    const Aabb box = box_for(*slot.shape, pose, body);
    w.changes.make_room_for(1);
    w.broad_phase.move(proxy, box);
    // Nothing below throws.
    slot.pose = pose;
    w.changes.mark(proxy, Change::body);
    if (w.trace) w.trace->write<calls::SetPose>(body, pose);
}

// Everything that can fail is done before a body moves; should the broad phase run out of memory half-way, the moves
// that it has are taken back, which needs none.
void World::set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses) {
    Impl& w = impl();
    if (bodies.size() != poses.size()) throw LengthMismatch(bodies.size(), poses.size());
    std::vector<Aabb> boxes;  // that the bodies get; those that they had, of bodies that have moved
    boxes.reserve(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ProxyIndex proxy = w.bodies.require(bodies[i], i);
        require_valid(poses[i], bodies[i], i);
        const Slot& slot = w.bodies[proxy];
        boxes.push_back(same_bits(slot.pose, poses[i]) ? w.broad_phase.box(proxy)
                                                       : box_for(*slot.shape, poses[i], bodies[i], i));
    }
    w.changes.make_room_for(bodies.size());
    std::size_t moved_count = 0;
    try {
        for (; moved_count < bodies.size(); ++moved_count) {
            const ProxyIndex proxy = bodies[moved_count].slot - 1;
            const Aabb old = w.broad_phase.box(proxy);
            w.broad_phase.move(proxy, boxes[moved_count]);
            boxes[moved_count] = old;
        }
    } catch (...) {
        while (moved_count-- > 0) {
            w.broad_phase.move(bodies[moved_count].slot - 1, boxes[moved_count]);
        }
        throw;
    }
    // Nothing below throws.
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ProxyIndex proxy = bodies[i].slot - 1;
        Slot& slot = w.bodies[proxy];
        if (same_bits(slot.pose, poses[i])) continue;
        slot.pose = poses[i];
        w.changes.mark(proxy, Change::body);
    }
    if (w.trace) w.trace->write<calls::SetPoses>(bodies, poses);
}

}  // namespace ecods
