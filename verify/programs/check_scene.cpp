#include "check_scene.hpp"

#include <algorithm>
#include <numeric>

namespace ecods::check {

SceneWorld::SceneWorld(const scenes::Scene& scene, BroadPhaseKind broad_phase, std::optional<double> clearance)
    : scene_(scene), world_(WorldOptions{.broad_phase = broad_phase}) {
    world_.set_clearance(clearance);
    for (const scenes::SceneBody& body : scene.bodies) {
        ids_.push_back(world_.create_body(scene.meshes[body.mesh_index].mesh, body.pose));
    }
}

bool SceneWorld::next_frame() {
    if (frame_count_ > scene_.frames.size()) return false;
    moved_.clear();
    if (frame_count_ == 0) {
        moved_.resize(ids_.size());
        std::iota(moved_.begin(), moved_.end(), std::size_t{0});
    } else {
        for (const scenes::Move& move : scene_.frames[frame_count_ - 1].moves) {
            world_.set_pose(ids_[move.body_index], move.pose);
            moved_.push_back(move.body_index);
        }
        std::sort(moved_.begin(), moved_.end());
    }
    world_.update();
    ++frame_count_;
    return true;
}

FrameAnswer SceneWorld::answer(bool has_distances) {
    FrameAnswer answer;
    answer.frame = frame_count_ - 1;
    for (const BodyPair& pair : world_.overlapping_pairs()) {
        answer.overlapping.emplace_back(body_of(pair.a), body_of(pair.b));
    }
    const std::vector<BodyPair> colliding(world_.colliding_pairs().begin(), world_.colliding_pairs().end());
    for (const BodyPair& pair : colliding) {
        answer.colliding.push_back({body_of(pair.a), body_of(pair.b), world_.relation(pair.a, pair.b),
                                    world_.intersecting_triangles(pair.a, pair.b)});
    }
    for (std::size_t a = 0; has_distances && a < ids_.size(); ++a) {
        for (std::size_t b = a + 1; b < ids_.size(); ++b) {
            answer.distances.push_back(distance(a, b));
        }
    }
    answer.clearance = world_.clearance();
    for (const BodyPair& pair : world_.close_pairs()) {
        answer.close.push_back(distance(body_of(pair.a), body_of(pair.b)));
    }
    return answer;
}

DistanceAnswer SceneWorld::distance(std::size_t a, std::size_t b) {
    return {a, b, closest(posed(a), posed(b), memory_)};
}

Posed<MeshShape> SceneWorld::posed(std::size_t body) const {
    return {dynamic_cast<const MeshShape&>(*world_.shape(ids_[body])), pose(body)};
}

std::size_t SceneWorld::body_of(BodyId id) const {
    return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

}  // namespace ecods::check
