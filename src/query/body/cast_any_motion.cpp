// Casts two bodies with any kinds of motions, by the cast for these two kinds. A body at rest counts as straight, as
// translated or as turned by the angle 0, whichever suits the motion of the other body.
#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/cast_along.hpp"
#include "query/body/cast_straight.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace {

// Returns the translation of a body that is at rest or translated; null for other motions.
const Vec3* translation(const Pose& start, const Motion& motion) {
    static const Vec3 rest = Vec3::Zero();
    if (const auto* const by = std::get_if<Translation>(&motion)) return &by->by;
    return straight_end(start, motion) == &start ? &rest : nullptr;
}

// Returns the first contact of a and b, found by cast_exchanged(ask), which must cast b against a.
template <class Cast>
std::optional<FirstContact> cast_in_other_order(const Ask& ask, const Cast& cast_exchanged) {
    Asking asking(ask);
    PairWitness& witness = asking.witness();
    PairWitness exchanged{witness.b, witness.a};
    auto contact = cast_exchanged(Ask{asking.memory(), exchanged});
    witness = {exchanged.b, exchanged.a};
    if (contact) std::swap(contact->a, contact->b);
    return contact;
}

bool is_turn(const Motion& motion) {
    return std::holds_alternative<Turn>(motion) || std::holds_alternative<Along>(motion);
}

Turning<MeshShape> turning(const Posed<MeshShape>& body, const Motion& turn) {
    return {*body.what, body.pose, turn_of(turn)};
}

// Returns the move of a body that goes straight to the pose `end`, or is translated by the motion if `end` is null.
StraightMove straight(const Posed<MeshShape>& body, const Pose* end, const Motion& motion) {
    if (end != nullptr) return {{*body.what, body.pose, *end}, {}};
    return {{*body.what, body.pose, body.pose}, std::get<Translation>(motion).by};
}

// Returns true if the nodes of a way are treated as a Turn (motion.hpp).
bool is_turn(const std::vector<WayNode>& nodes) {
    return nodes.size() == 2 && nodes[0].q == Quaternion();
}

bool is_same_place(const Pose& a, const Pose& b) {
    return same_point(a.t, b.t) && same_matrix(a.R, b.R);
}

}  // namespace

void MotionKinds::add(const Pose& start, const Motion& motion) {
    if (straight_end(start, motion) == &start) return;
    ++moving_count_;
    if (nodes_of(motion) != nullptr) ++way_count_;
}

void MotionKinds::require_casts() const {
    if (way_count_ > 0 && moving_count_ > 1) throw NotSupported("a body goes along a way, and another one moves");
}

const Pose* straight_end(const Pose& start, const Motion& motion) {
    if (const auto* const straight = std::get_if<Straight>(&motion)) {
        return is_same_place(straight->to, start) ? &start : &straight->to;
    }
    const auto* const translated = std::get_if<Translation>(&motion);
    return translated != nullptr && is_zero(translated->by) ? &start : nullptr;
}

const std::vector<WayNode>* nodes_of(const Motion& motion) {
    const auto* const along = std::get_if<Along>(&motion);
    return along == nullptr || is_turn(along->nodes) ? nullptr : &along->nodes;
}

Turn turn_of(const Motion& motion) {
    if (const auto* const turn = std::get_if<Turn>(&motion)) return *turn;
    if (const auto* const along = std::get_if<Along>(&motion)) {
        return {along->nodes[1].q, along->nodes[0].pivot, along->nodes[1].pivot};
    }
    return {{}, Vec3::Zero(), std::get<Translation>(motion).by};
}

namespace {

// Casts a body that turns against one that is translated or goes straight to a pose.
std::optional<FirstContact> cast_turn(const Turning<MeshShape>& a, const Posed<MeshShape>& b, const Motion& motion_of_b,
                                      double max_time, const Ask& ask) {
    if (const Vec3* const way = translation(b.pose, motion_of_b)) return cast(a, *way, b, max_time, ask);
    const Moving<MeshShape> moving(*b.what, b.pose, std::get<Straight>(motion_of_b).to);
    return cast(a, moving, max_time, ask);
}

}  // namespace

std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Motion& motion_of_a, const Posed<MeshShape>& b,
                                 const Motion& motion_of_b, double max_time, const Ask& ask) {
    validate(motion_of_a);
    validate(motion_of_b);
    MotionKinds kinds;
    kinds.add(a.pose, motion_of_a);
    kinds.add(b.pose, motion_of_b);
    kinds.require_casts();
    if (const auto* const nodes = nodes_of(motion_of_a)) return cast_along(a, *nodes, b, max_time, ask);
    if (const auto* const nodes = nodes_of(motion_of_b)) {
        return cast_in_other_order(ask,
                                   [&](const Ask& exchanged) { return cast_along(b, *nodes, a, max_time, exchanged); });
    }
    const Pose* const end_a = straight_end(a.pose, motion_of_a);
    const Pose* const end_b = straight_end(b.pose, motion_of_b);
    if (end_a != nullptr && end_b != nullptr) {
        return cast(Moving<MeshShape>(*a.what, a.pose, *end_a), Moving<MeshShape>(*b.what, b.pose, *end_b), max_time,
                    ask);
    }
    const Vec3* const way_a = translation(a.pose, motion_of_a);
    const Vec3* const way_b = translation(b.pose, motion_of_b);
    if (way_a != nullptr && end_b == &b.pose) return cast(a, *way_a, b, max_time, ask);
    if (way_b != nullptr && end_a == &a.pose) return cast(a, Vec3(-*way_b), b, max_time, ask);
    if (is_turn(motion_of_a) && is_turn(motion_of_b)) {
        return cast(turning(a, motion_of_a), turning(b, motion_of_b), max_time, ask);
    }
    if (is_turn(motion_of_a)) return cast_turn(turning(a, motion_of_a), b, motion_of_b, max_time, ask);
    if (is_turn(motion_of_b)) {
        return cast_in_other_order(ask, [&](const Ask& exchanged) {
            return cast_turn(turning(b, motion_of_b), a, motion_of_a, max_time, exchanged);
        });
    }
    return cast(straight(a, end_a, motion_of_a), straight(b, end_b, motion_of_b), max_time, ask);
}

}  // namespace ecods
