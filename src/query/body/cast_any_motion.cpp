// Casts of two bodies of any motions are those of their kinds. A body at rest counts as straight, as translated and as
// turned by nothing, whichever the motion of the other one is.
#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
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

// Returns the contact of a and b, where cast_exchanged(ask) casts b against a.
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

Turning<MeshShape> turning(const Posed<MeshShape>& body, const Turn& turn) {
    return {*body.what, body.pose, turn};
}

// `end` is the pose to which a body goes straight; null if it is translated.
StraightMove straight(const Posed<MeshShape>& body, const Pose* end, const Motion& motion) {
    if (end != nullptr) return {{*body.what, body.pose, *end}, {}};
    return {{*body.what, body.pose, body.pose}, std::get<Translation>(motion).by};
}

bool is_same_place(const Pose& a, const Pose& b) {
    return same_point(a.t, b.t) && same_point(a.R.col(0), b.R.col(0)) && same_point(a.R.col(1), b.R.col(1)) &&
           same_point(a.R.col(2), b.R.col(2));
}

}  // namespace

const Pose* straight_end(const Pose& start, const Motion& motion) {
    if (const auto* const straight = std::get_if<Straight>(&motion)) {
        return is_same_place(straight->to, start) ? &start : &straight->to;
    }
    const auto* const translated = std::get_if<Translation>(&motion);
    return translated != nullptr && is_zero(translated->by) ? &start : nullptr;
}

Turn turn_of(const Motion& motion) {
    if (const auto* const turn = std::get_if<Turn>(&motion)) return *turn;
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
    const auto* const turn_a = std::get_if<Turn>(&motion_of_a);
    const auto* const turn_b = std::get_if<Turn>(&motion_of_b);
    if (turn_a != nullptr && turn_b != nullptr) return cast(turning(a, *turn_a), turning(b, *turn_b), max_time, ask);
    if (turn_b != nullptr) {
        return cast_in_other_order(ask, [&](const Ask& exchanged) {
            return cast_turn(turning(b, *turn_b), a, motion_of_a, max_time, exchanged);
        });
    }
    if (turn_a != nullptr) return cast_turn(turning(a, *turn_a), b, motion_of_b, max_time, ask);
    return cast(straight(a, end_a, motion_of_a), straight(b, end_b, motion_of_b), max_time, ask);
}

}  // namespace ecods
