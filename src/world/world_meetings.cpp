#include <algorithm>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/intersection/asking.hpp"
#include "world/straight_moves.hpp"
#include "world/way_box.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Stores the bodies that move or changed, each with its motion and a box that contains its whole motion.
class Ways {
  public:
    // Sets the motion of the body, and the box `way` of it; replaces earlier values of the same body.
    void set(ProxyIndex proxy, const Motion& motion, const Aabb& way) {
        const auto [at, is_new] = places_.try_emplace(proxy, bodies_.size());
        if (is_new) {
            bodies_.push_back(proxy);
            motions_.push_back(motion);
            boxes_.push_back(way);
        } else {
            motions_[at->second] = motion;
            boxes_[at->second] = way;
        }
    }
    bool has(ProxyIndex proxy) const { return places_.contains(proxy); }
    const Motion& motion(ProxyIndex proxy) const {
        static const Motion rest;
        const auto at = places_.find(proxy);
        return at == places_.end() ? rest : motions_[at->second];
    }
    std::span<const ProxyIndex> bodies() const noexcept { return bodies_; }
    std::span<const Aabb> boxes() const noexcept { return boxes_; }

  private:
    std::unordered_map<ProxyIndex, std::size_t> places_;
    std::vector<ProxyIndex> bodies_;
    std::vector<Motion> motions_;
    std::vector<Aabb> boxes_;
};

// Returns the first contact of two moving bodies, with the test's first kind first.
std::optional<FirstContact> meet(const TwoBodyTest& test, const Slot& a, const Motion& motion_of_a, const Slot& b,
                                 const Motion& motion_of_b, QueryMemory& memory) {
    const Pose* const end_a = straight_end(a.pose, motion_of_a);
    const Pose* const end_b = straight_end(b.pose, motion_of_b);
    if (end_a == nullptr || end_b == nullptr) {
        return test.cast_any_motion(a.posed(), motion_of_a, b.posed(), motion_of_b, 1, memory);
    }
    return test.cast_moving(Moving<Shape>(*a.shape, a.pose, *end_a), Moving<Shape>(*b.shape, b.pose, *end_b), 1,
                            memory);
}

// Appends the pairs that may collide although neither body is in `ways`: pairs that collided at the last update, and
// pairs that were switched on or off since then. May append a pair twice.
void append_known(const PairVerdicts& collisions, const Changes& changes, const Bodies& bodies, const Ways& ways,
                  ProxyPairs& pairs) {
    const auto append = [&](const ProxyPair& pair) {
        if (!ways.has(pair.a) && !ways.has(pair.b)) pairs.push_back(pair);
    };
    for (const BodyPair& pair : collisions.positive()) {
        if (bodies.is_alive(pair.a) && bodies.is_alive(pair.b)) append({pair.a.slot - 1, pair.b.slot - 1});
    }
    for (const ProxyPair& pair : changes.switched()) {
        if (bodies[pair.a].is_alive() && bodies[pair.b].is_alive()) append(pair);
    }
}

// Throws the errors of the motion, with the body, and with the motion's index in its list.
void require_valid(const Motion& motion, BodyId body, std::size_t index) {
    try {
        validate(motion);
    } catch (const InvalidArgument& error) {
        throw error.at(body, index);
    }
}

// Throws NotSupported if a body of the world moves straight to a pose, and rounded bodies have no cast for this move.
void require_straight_casts(const Ways& ways, const Bodies& bodies, const TwoBodyTests& tests) {
    const auto end_of = [&](ProxyIndex proxy) {
        return ways.has(proxy) ? straight_end(bodies[proxy].pose, ways.motion(proxy)) : nullptr;
    };
    StraightMoves listed, all;
    for (const ProxyIndex proxy : ways.bodies()) listed.add(bodies[proxy].posed(), end_of(proxy));
    if (!listed.has_turning()) return;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        if (bodies[proxy].is_alive()) all.add(bodies[proxy].posed(), end_of(proxy));
    }
    all.require_casts(tests);
}

// Returns true if some body turns or is translated. Throws NotSupported if no cast takes the motions of some two
// bodies.
bool are_any_motions(const Ways& ways, const Bodies& bodies) {
    MotionKinds kinds;
    bool are_any = false;
    for (const ProxyIndex proxy : ways.bodies()) {
        const Pose& start = bodies[proxy].pose;
        kinds.add(start, ways.motion(proxy));
        are_any = are_any || straight_end(start, ways.motion(proxy)) == nullptr;
    }
    kinds.require_casts();
    return are_any;
}

}  // namespace

// Searches for the pairs in which a body is listed in `bodies` or has changed since the last update. For every other
// pair, the last update has found whether the two collide.
std::vector<Meeting> World::Impl::find_meetings(std::span<const BodyId> listed, std::span<const Motion> motions,
                                                const Ask& ask) const {
    Asking asking(ask);
    Ways ways;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const ProxyIndex proxy = bodies.require(listed[i], i);
        require_valid(motions[i], listed[i], i);
        const Slot& slot = bodies[proxy];
        const Aabb& from = broad_phase.box(proxy);
        ways.set(proxy, motions[i], box_of_way(*slot.shape, slot.pose, from, motions[i], listed[i], i));
    }
    require_answers(Question::cast_moving);
    if (are_any_motions(ways, bodies)) require_answers(Question::cast_any_motion);
    if (bodies.has_rounded()) require_straight_casts(ways, bodies, tests);
    for (const ProxyIndex proxy : changes.bodies()) {
        if (bodies[proxy].is_alive() && !ways.has(proxy)) ways.set(proxy, Motion(), broad_phase.box(proxy));
    }
    ProxyPairs pairs;
    broad_phase.find_pairs_with(ways.bodies(), ways.boxes(), pairs);
    append_known(collisions, changes, bodies, ways, pairs);
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    std::vector<Meeting> result;
    for (const ProxyPair& pair : pairs) {
        if (!bodies.is_enabled(pair)) continue;
        const OrderedTest test = test_of(pair);
        const auto [first, second] = test.swapped ? std::pair(pair.b, pair.a) : std::pair(pair.a, pair.b);
        const auto contact = in_order(test, meet(*test.test, bodies[first], ways.motion(first), bodies[second],
                                                 ways.motion(second), asking.memory()));
        if (contact) result.push_back({bodies.ids_of(pair), *contact});
    }
    std::ranges::sort(result, {},
                      [](const Meeting& meeting) { return std::tuple(key_of(meeting.contact.time), meeting.bodies); });
    return result;
}

std::vector<Meeting> World::meetings(std::span<const BodyId> bodies, std::span<const Pose> poses,
                                     const Ask& ask) const {
    const Impl& w = impl();
    if (bodies.size() != poses.size()) throw invalid_list_length(bodies.size(), poses.size());
    std::vector<Motion> motions;
    motions.reserve(poses.size());
    for (const Pose& pose : poses) motions.emplace_back(Straight{pose});
    return w.traced<calls::Meetings>(ask, w.find_meetings(bodies, motions, ask), bodies, poses);
}

std::vector<Meeting> World::meetings(std::span<const BodyId> bodies, std::span<const Motion> motions,
                                     const Ask& ask) const {
    const Impl& w = impl();
    if (bodies.size() != motions.size()) throw invalid_list_length(bodies.size(), motions.size(), "motions");
    return w.traced<calls::MeetingsOfMotions>(ask, w.find_meetings(bodies, motions, ask), bodies, motions);
}

}  // namespace ecods
