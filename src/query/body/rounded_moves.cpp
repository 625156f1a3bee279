// Casts rounded bodies that move from pose to pose, or in any way, if each of them is translated. The motion of one
// relative to the other is then a translation by an exact vector, whose coordinates need not be doubles. For all other
// motions, times at which cores are at a distance are roots of polynomials of degree 6 and more, and NotSupported is
// thrown.
#include "query/body/rounded_moves.hpp"

#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/turn.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/body/rounded_pair.hpp"

namespace ecods {
namespace {

using exact::exact_vector;
using exact::ScaledLongVector;
using MaybeVector = std::optional<ScaledLongVector>;

// Returns the position at which all corners of the core's triangles are; null if they are at several positions.
const Vec3* only_vertex(const MeshShape& core) {
    const Mesh& mesh = core.mesh();
    const Vec3& first = mesh.vertices()[mesh.triangles()[0][0]];
    for (const Triangle& triangle : mesh.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!same_point(mesh.vertices()[triangle[i]], first)) return nullptr;
        }
    }
    return &first;
}

// Returns the first contact of two bodies that are translated by a and b, at least one of which has a radius. Throws
// NotSupported if a or b is nullopt: that body is not translated.
std::optional<FirstContact> cast_on_ways(const RoundedPair& pair, const MaybeVector& a, const MaybeVector& b,
                                         Question question, double latest, const Ask& ask) {
    if (!a || !b) throw NotSupported(question, pair.a.kind, pair.b.kind);
    return pair.cast_along(exact::minus(*a, *b), 0, latest, ask);
}

std::optional<FirstContact> cast_any(const RoundedPair& pair, const Motion& motion_of_a, const Motion& motion_of_b,
                                     double max_time, const Ask& ask) {
    if (pair.radii().sum().sign() == 0) {
        return cast(pair.a.core, motion_of_a, pair.b.core, motion_of_b, max_time, ask);
    }
    const double latest = require_time(max_time);
    validate(motion_of_a);
    validate(motion_of_b);
    return cast_on_ways(pair, translation_of(pair.a.core, motion_of_a), translation_of(pair.b.core, motion_of_b),
                        Question::cast_any_motion, latest, ask);
}

template <class Thing>
Posed<Thing> start_of(const Moving<Thing>& moving) {
    return {*moving.what, moving.from};
}

}  // namespace

std::optional<FirstContact> RoundedPair::cast_straight(const Pose& end_a, const Pose& end_b, double max_time,
                                                       const Ask& ask) const {
    if (radii().sum().sign() == 0) {
        return ecods::cast(Moving<MeshShape>(*a.core.what, a.core.pose, end_a),
                           Moving<MeshShape>(*b.core.what, b.core.pose, end_b), max_time, ask);
    }
    const double latest = require_time(max_time);
    return cast_on_ways(*this, translation_of(a.core, end_a), translation_of(b.core, end_b), Question::cast_moving,
                        latest, ask);
}

std::optional<ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Pose& end) {
    if (same_matrix(core.pose.R, end.R)) return exact::minus(exact_vector(end.t), exact_vector(core.pose.t));
    const Vec3* const v = only_vertex(*core.what);
    if (v == nullptr) return std::nullopt;
    return exact::minus(exact::posed_point(end, *v), exact::posed_point(core.pose, *v));
}

std::optional<ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Motion& motion) {
    if (const auto* const by = std::get_if<Translation>(&motion)) return exact_vector(by->by);
    if (const auto* const straight = std::get_if<Straight>(&motion)) return translation_of(core, straight->to);
    if (nodes_of(motion) != nullptr) return std::nullopt;
    const Turn turn = turn_of(motion);
    const ScaledLongVector from = exact_vector(turn.pivot_from), axis = exact_vector({turn.q.x, turn.q.y, turn.q.z});
    ScaledLongVector glide = exact::minus(exact_vector(turn.pivot_to), from);
    if (exact::is_zero(axis)) return glide;
    const Vec3* const v = only_vertex(*core.what);
    if (v == nullptr) return std::nullopt;
    const ScaledLongVector beside = exact::minus(exact::posed_point(core.pose, *v), from);
    if (!exact::is_zero(exact::cross(beside, axis))) return std::nullopt;
    return glide;
}

std::optional<FirstContact> cast(const Moving<Rounded>& a, const Moving<Rounded>& b, double max_time, const Ask& ask) {
    return RoundedPair{start_of(a), start_of(b)}.cast_straight(a.to, b.to, max_time, ask);
}
std::optional<FirstContact> cast(const Moving<Rounded>& a, const Moving<MeshShape>& b, double max_time,
                                 const Ask& ask) {
    return RoundedPair{start_of(a), start_of(b)}.cast_straight(a.to, b.to, max_time, ask);
}
std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<Rounded>& b, double max_time,
                                 const Ask& ask) {
    return RoundedPair{start_of(a), start_of(b)}.cast_straight(a.to, b.to, max_time, ask);
}

std::optional<FirstContact> cast(const Posed<Rounded>& a, const Motion& motion_of_a, const Posed<Rounded>& b,
                                 const Motion& motion_of_b, double max_time, const Ask& ask) {
    return cast_any({a, b}, motion_of_a, motion_of_b, max_time, ask);
}
std::optional<FirstContact> cast(const Posed<Rounded>& a, const Motion& motion_of_a, const Posed<MeshShape>& b,
                                 const Motion& motion_of_b, double max_time, const Ask& ask) {
    return cast_any({a, b}, motion_of_a, motion_of_b, max_time, ask);
}
std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Motion& motion_of_a, const Posed<Rounded>& b,
                                 const Motion& motion_of_b, double max_time, const Ask& ask) {
    return cast_any({a, b}, motion_of_a, motion_of_b, max_time, ask);
}

}  // namespace ecods
