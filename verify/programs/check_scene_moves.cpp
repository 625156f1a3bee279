// Who meets on the way from frame to frame, and who is met by bodies that are cast: straight, or by a turn.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "check_scene.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"

namespace ecods::check {

void SceneWorld::find_meetings(const scenes::Frame& frame) {
    poses_before_.clear();
    for (const BodyId body : ids_) poses_before_.push_back(world_.pose(body));
    poses_after_ = poses_before_;
    turns_.assign(ids_.size(), std::nullopt);
    std::vector<BodyId> bodies;
    std::vector<Pose> poses;
    for (const scenes::Move& move : frame.moves) {
        poses_after_[move.body_index] = move.pose;
        turns_[move.body_index] = move.turn;
        if (move.turn) continue;
        bodies.push_back(ids_[move.body_index]);
        poses.push_back(move.pose);
    }
    meetings_.clear();
    for (const Meeting& meeting : world_.meetings(bodies, poses)) {
        const std::size_t a = body_of(meeting.bodies.a), b = body_of(meeting.bodies.b);
        if (!turns_[a] && !turns_[b]) meetings_.push_back({a, b, meeting.contact});
    }
    find_turn_meetings();
}

// Each body that turns is asked about all others: of two that turn, the first.
void SceneWorld::find_turn_meetings() {
    for (std::size_t a = 0; a < ids_.size(); ++a) {
        for (std::size_t b = 0; turns_[a] && b < ids_.size(); ++b) {
            if (b == a || (turns_[b] && b < a)) continue;
            const auto contact = cast_of_turn(a, b);
            if (contact) meetings_.push_back({a, b, *contact, angle_at(*turns_[a], contact->time)});
        }
    }
    std::ranges::sort(meetings_, {}, [](const MeetingAnswer& x) { return std::tuple(x.contact.time, x.a, x.b); });
}

std::optional<FirstContact> SceneWorld::cast_of_turn(std::size_t a, std::size_t b) {
    const auto motion = [&](std::size_t body) {
        return turns_[body] ? Motion(*turns_[body]) : Motion(Straight{poses_after_[body]});
    };
    try {
        return cast(posed_before(a), motion(a), posed_before(b), motion(b), 1, memory_);
    } catch (const NotSupported& error) {
        throw NotSupported(fmt::format("frame {}: \"{}\" and \"{}\": {}", frame_count_, scene_.bodies[a].name,
                                       scene_.bodies[b].name, error.what()));
    }
}

std::vector<MeetingAnswer> SceneWorld::casts() {
    std::vector<MeetingAnswer> casts;
    for (std::size_t body = 0; body < ids_.size(); ++body) {
        const scenes::SceneBody& moved = scene_.bodies[body];
        if (moved.turn) {
            const auto met = world_.cast(ids_[body], Motion(*moved.turn));
            if (met) {
                casts.push_back({body, body_of(met->body), met->contact, angle_at(*moved.turn, met->contact.time)});
            }
        }
        if (!moved.motion) continue;
        const auto met = world_.cast(ids_[body], *moved.motion);
        if (met) casts.push_back({body, body_of(met->body), met->contact});
    }
    return casts;
}

Posed<MeshShape> SceneWorld::posed_before(std::size_t body) const {
    return {*posed(body).what, poses_before_[body]};
}

}  // namespace ecods::check
