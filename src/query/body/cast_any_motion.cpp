// Casts two bodies that move in any way, by the cast for the kinds of their motions: two straight motions, two
// translations, two turns, or a turn and a translation.
#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
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

// Casts a, translated, against b, which turns.
std::optional<FirstContact> cast_turn_second(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                             const Turn& turn, double max_time, const Ask& ask) {
    Asking asking(ask);
    PairWitness& witness = asking.witness();
    PairWitness exchanged{witness.b, witness.a};
    auto contact = cast(Turning<MeshShape>(*b.what, b.pose, turn), motion, a, max_time, {asking.memory(), exchanged});
    witness = {exchanged.b, exchanged.a};
    if (contact) std::swap(contact->a, contact->b);
    return contact;
}

bool is_same_place(const Pose& a, const Pose& b) {
    return same_point(a.t, b.t) && same_point(a.R.col(0), b.R.col(0)) && same_point(a.R.col(1), b.R.col(1)) &&
           same_point(a.R.col(2), b.R.col(2));
}

}  // namespace

void MotionKinds::add(const Pose& start, const Motion& motion) {
    if (straight_end(start, motion) == &start) return;
    ++(std::holds_alternative<Turn>(motion)       ? turn_count_
       : std::holds_alternative<Straight>(motion) ? straight_count_
                                                  : translation_count_);
}

void MotionKinds::require_casts() const {
    if (straight_count_ == 0) return;
    if (turn_count_ > 0) throw NotSupported("a body goes straight to a pose, and another one turns");
    if (translation_count_ > 0) throw NotSupported("a body goes straight to a pose, and another one is translated");
}

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

std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Motion& motion_of_a, const Posed<MeshShape>& b,
                                 const Motion& motion_of_b, double max_time, const Ask& ask) {
    validate(motion_of_a);
    validate(motion_of_b);
    MotionKinds kinds;
    kinds.add(a.pose, motion_of_a);
    kinds.add(b.pose, motion_of_b);
    kinds.require_casts();
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
    if (way_a == nullptr && way_b == nullptr) {
        return cast(Turning<MeshShape>(*a.what, a.pose, turn_of(motion_of_a)),
                    Turning<MeshShape>(*b.what, b.pose, turn_of(motion_of_b)), max_time, ask);
    }
    if (way_b == nullptr) return cast_turn_second(a, *way_a, b, turn_of(motion_of_b), max_time, ask);
    return cast(Turning<MeshShape>(*a.what, a.pose, turn_of(motion_of_a)), *way_b, b, max_time, ask);
}

}  // namespace ecods
