#include <vector>

#include "base/make_error.hpp"
#include "geometry/same_bits.hpp"
#include "world/moved_boxes.hpp"
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

// Performs all operations that can fail before it moves the first body, so that an error leaves all bodies where they
// are.
void World::set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses) {
    Impl& w = impl();
    if (bodies.size() != poses.size()) throw invalid_list_length(bodies.size(), poses.size());
    std::vector<ProxyIndex> proxies;
    std::vector<Aabb> boxes(bodies.size());
    proxies.reserve(bodies.size());
    MovedBoxes moved(boxes);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ProxyIndex proxy = w.bodies.require(bodies[i], i);
        require_valid(poses[i], bodies[i], i);
        const Slot& slot = w.bodies[proxy];
        proxies.push_back(proxy);
        if (same_bits(slot.pose, poses[i])) {
            boxes[i] = w.broad_phase.box(proxy);
        } else if (!moved.add(*slot.shape, poses[i], i)) {
            boxes[i] = box_for(*slot.shape, poses[i], bodies[i], i);
        }
    }
    moved.finish();
    w.changes.make_room_for(bodies.size());
    w.broad_phase.move(proxies, boxes);
    // Nothing below throws.
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Slot& slot = w.bodies[proxies[i]];
        if (same_bits(slot.pose, poses[i])) continue;
        slot.pose = poses[i];
        w.changes.mark(proxies[i], Change::body);
    }
    if (w.trace) w.trace->write<calls::SetPoses>(bodies, poses);
}

}  // namespace ecods
