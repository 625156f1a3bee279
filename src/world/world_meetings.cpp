#include <algorithm>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "geometry/same_bits.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Returns a box that contains every point of a body while it moves between two poses with these boxes. Each point moves
// on a straight line, so each of its coordinates stays between its values at the two ends.
Aabb box_of_way(const Aabb& from, const Aabb& to) {
    Aabb box = from;
    for (int axis = 0; axis < 3; ++axis) {
        if (key_of(to.min[axis]) < key_of(box.min[axis])) box.min[axis] = to.min[axis];
        if (key_of(to.max[axis]) > key_of(box.max[axis])) box.max[axis] = to.max[axis];
    }
    return box;
}

// Stores the bodies that move or changed, each with its new pose and a box that contains its whole motion.
class Ways {
  public:
    // Sets the new pose of the body, and the box `way` of its motion; replaces earlier values of the same body.
    void set(ProxyIndex proxy, const Pose& to, const Aabb& way) {
        const auto [at, is_new] = places_.try_emplace(proxy, bodies_.size());
        if (is_new) {
            bodies_.push_back(proxy);
            to_.push_back(to);
            boxes_.push_back(way);
        } else {
            to_[at->second] = to;
            boxes_[at->second] = way;
        }
    }
    bool has(ProxyIndex proxy) const { return places_.contains(proxy); }
    const Pose* to(ProxyIndex proxy) const {
        const auto at = places_.find(proxy);
        return at == places_.end() ? nullptr : &to_[at->second];
    }
    std::span<const ProxyIndex> bodies() const noexcept { return bodies_; }
    std::span<const Aabb> boxes() const noexcept { return boxes_; }

  private:
    std::unordered_map<ProxyIndex, std::size_t> places_;
    std::vector<ProxyIndex> bodies_;
    std::vector<Pose> to_;
    std::vector<Aabb> boxes_;
};

Moving<Shape> moving(const Slot& slot, const Pose* to) {
    return {*slot.shape, slot.pose, to != nullptr ? *to : slot.pose};
}

std::optional<FirstContact> meet(const OrderedTest& test, const Moving<Shape>& a, const Moving<Shape>& b,
                                 QueryMemory& memory) {
    if (!test.swapped) return test.test->cast_moving(a, b, 1, memory);
    auto contact = test.test->cast_moving(b, a, 1, memory);
    if (contact) std::swap(contact->a, contact->b);
    return contact;
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

}  // namespace

// Searches for the pairs in which a body is listed in `bodies` or has changed since the last update. For every other
// pair, the last update has found whether the two collide.
std::vector<Meeting> World::meetings(std::span<const BodyId> bodies, std::span<const Pose> poses,
                                     const Ask& ask) const {
    const Impl& w = impl();
    Asking asking(ask);
    if (bodies.size() != poses.size()) throw invalid_list_length(bodies.size(), poses.size());
    Ways ways;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ProxyIndex proxy = w.bodies.require(bodies[i], i);
        require_valid(poses[i], bodies[i], i);
        const Slot& slot = w.bodies[proxy];
        const Aabb& from = w.broad_phase.box(proxy);
        ways.set(
            proxy, poses[i],
            same_bits(slot.pose, poses[i]) ? from : box_of_way(from, box_for(*slot.shape, poses[i], bodies[i], i)));
    }
    w.require_answers(Question::cast_moving);
    for (const ProxyIndex proxy : w.changes.bodies()) {
        if (!w.bodies[proxy].is_alive() || ways.has(proxy)) continue;
        ways.set(proxy, w.bodies[proxy].pose, w.broad_phase.box(proxy));
    }
    ProxyPairs pairs;
    w.broad_phase.find_pairs_with(ways.bodies(), ways.boxes(), pairs);
    append_known(w.collisions, w.changes, w.bodies, ways, pairs);
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    std::vector<Meeting> result;
    for (const ProxyPair& pair : pairs) {
        if (!w.bodies.is_enabled(pair)) continue;
        const Slot &a = w.bodies[pair.a], &b = w.bodies[pair.b];
        const auto contact =
            meet(w.tests.find(a.kind, b.kind), moving(a, ways.to(pair.a)), moving(b, ways.to(pair.b)), asking.memory());
        if (contact) result.push_back({w.bodies.ids_of(pair), *contact});
    }
    std::ranges::sort(result, {},
                      [](const Meeting& meeting) { return std::tuple(key_of(meeting.contact.time), meeting.bodies); });
    return w.traced<calls::Meetings>(ask, std::move(result), bodies, poses);
}

}  // namespace ecods
