// Implements the casts of cast.hpp. If a part of one body is inside the other at the start, the bodies meet at time 0;
// otherwise their first contact is that of their boundaries.
#include "ecods/cast.hpp"

#include "base/limits.hpp"
#include "ecods/turn.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/cast_straight.hpp"
#include "query/body/contained.hpp"
#include "query/cast/cast_until.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

// Returns the first contact of two bodies. `find(a, b)` must cast the boundaries.
template <class Function>
std::optional<FirstContact> cast_boundaries(const BodyPairAsked& bodies, QueryMemory& memory, const Function& find) {
    return as_one_query(memory, [&]() -> std::optional<FirstContact> {
        if (const auto features = find_contained(bodies, memory)) {
            return FirstContact{0, ClosestKind::contained, features->a, features->b};
        }
        auto contact = find(bodies.a.boundary(), bodies.b.boundary());
        if (contact) bodies.rename(*contact);
        return contact;
    });
}

}  // namespace

std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                 double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    Asking asking(ask);
    const auto cast = [&](const Posed<MeshShape>& x, const Posed<MeshShape>& y) {
        return cast_until(x, motion, y, latest, asking.memory(), asking.witness());
    };
    if (are_surfaces(*a.what, *b.what)) return cast(a, b);
    validate_motion(motion);
    return cast_boundaries({a, b}, asking.memory(), cast);
}

std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double max_time,
                                 const Ask& ask) {
    const double latest = require_time(max_time);
    Asking asking(ask);
    if (are_surfaces(*a.what, *b.what)) return cast_until(a, b, latest, asking.memory(), asking.witness());
    const BodyPairAsked bodies({*a.what, a.from}, {*b.what, b.from});
    return cast_boundaries(bodies, asking.memory(), [&](const Posed<MeshShape>& x, const Posed<MeshShape>& y) {
        return cast_until(Moving<MeshShape>(*x.what, a.from, a.to), Moving<MeshShape>(*y.what, b.from, b.to), latest,
                          asking.memory(), asking.witness());
    });
}

std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Posed<MeshShape>& b, double max_time,
                                 const Ask& ask) {
    return cast(a, Vec3::Zero(), b, max_time, ask);
}

std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                                 double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    validate(a.turn);
    validate_motion(motion_of_b);
    Asking asking(ask);
    const auto cast = [&](const Turning<MeshShape>& x, const Posed<MeshShape>& y) {
        return cast_until(x, motion_of_b, y, latest, asking.memory(), asking.witness());
    };
    if (are_surfaces(*a.what, *b.what)) return cast(a, b);
    return cast_boundaries({{*a.what, a.pose}, b}, asking.memory(),
                           [&](const Posed<MeshShape>& x, const Posed<MeshShape>& y) {
                               return cast(Turning<MeshShape>(*x.what, a.pose, a.turn), y);
                           });
}

std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Turning<MeshShape>& b, double max_time,
                                 const Ask& ask) {
    const double latest = require_time(max_time);
    for (const Turning<MeshShape>* body : {&a, &b}) {
        validate(body->pose);
        validate(body->turn);
    }
    Asking asking(ask);
    if (are_surfaces(*a.what, *b.what)) return cast_until(a, b, latest, asking.memory(), asking.witness());
    return cast_boundaries({{*a.what, a.pose}, {*b.what, b.pose}}, asking.memory(),
                           [&](const Posed<MeshShape>& x, const Posed<MeshShape>& y) {
                               return cast_until(Turning<MeshShape>(*x.what, a.pose, a.turn),
                                                 Turning<MeshShape>(*y.what, b.pose, b.turn), latest, asking.memory(),
                                                 asking.witness());
                           });
}

std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double max_time,
                                 const Ask& ask) {
    const double latest = require_time(max_time);
    Asking asking(ask);
    const auto cast = [&](const MeshShape& x, const MeshShape& y) {
        return cast_until(Turning<MeshShape>(x, a.pose, a.turn), Moving<MeshShape>(y, b.from, b.to), latest,
                          asking.memory(), asking.witness());
    };
    if (are_surfaces(*a.what, *b.what)) return cast(*a.what, *b.what);
    return cast_boundaries({{*a.what, a.pose}, {*b.what, b.from}}, asking.memory(),
                           [&](const auto& x, const auto& y) { return cast(*x.what, *y.what); });
}

std::optional<FirstContact> cast(const StraightMove& a, const StraightMove& b, double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    Asking asking(ask);
    const auto move_of = [](const StraightMove& move, const MeshShape& shape) {
        return StraightMove{{shape, move.body.from, move.body.to}, move.translation};
    };
    const auto cast = [&](const MeshShape& x, const MeshShape& y) {
        return cast_until(move_of(a, x), move_of(b, y), latest, asking.memory(), asking.witness());
    };
    const MeshShape &of_a = *a.body.what, &of_b = *b.body.what;
    if (are_surfaces(of_a, of_b)) return cast(of_a, of_b);
    return cast_boundaries({{of_a, a.body.from}, {of_b, b.body.from}}, asking.memory(),
                           [&](const auto& x, const auto& y) { return cast(*x.what, *y.what); });
}

std::optional<WayContact> cast(const Way<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    validate(a.nodes);
    Asking asking(ask);
    const Posed<MeshShape> start(*a.what, a.pose);
    if (are_surfaces(*a.what, *b.what)) return cast_until(a, b, asking.memory(), asking.witness());
    std::size_t leg = 0;
    const auto contact = cast_boundaries({start, b}, asking.memory(), [&](const auto& x, const auto& y) {
        const auto found = cast_until(Way<MeshShape>(*x.what, a.pose, a.nodes), y, asking.memory(), asking.witness());
        leg = found ? found->leg : 0;
        return found ? std::optional(found->contact) : std::nullopt;
    });
    return contact ? std::optional(WayContact{leg, *contact}) : std::nullopt;
}

namespace {

std::optional<FirstContact> settle_on(const Posed<MeshShape>& a, const TurnLeg& leg, const Pose& to,
                                      const Posed<MeshShape>& b, const Ask& ask) {
    validate(to);
    Asking asking(ask);
    const BodyPairAsked bodies(a, b);
    const Posed<MeshShape>& of_b = bodies.b.boundary();
    auto contact = settle_from(*bodies.a.boundary().what, leg, to, of_b, asking.memory(), asking.witness());
    if (!contact) return std::nullopt;
    bodies.rename(*contact);
    return contact;
}

}  // namespace

std::optional<FirstContact> settle(const Turning<MeshShape>& a, const Pose& to, const Posed<MeshShape>& b,
                                   const Ask& ask) {
    validate(a.turn);
    return settle_on({*a.what, a.pose}, leg_of(a.pose, a.turn), to, b, ask);
}

std::optional<FirstContact> settle(const Way<MeshShape>& a, const Pose& to, const Posed<MeshShape>& b, const Ask& ask) {
    validate(a.nodes);
    return settle_on({*a.what, a.pose}, leg_of(a.pose, a.nodes, last_leg(a.nodes)), to, b, ask);
}

}  // namespace ecods
