// This file computes the point and the normal of the first contact of bodies that turn, or that move from pose to pose.
#include <array>
#include <optional>

#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "exact/measure/contact/meeting_place.hpp"
#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "geometry/find_invalid.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {
namespace {

using exact::Integer;
using exact::MeetingPlace;
using exact::Polynomial;

using Triangles = std::array<std::uint32_t, 2>;

// Returns the pair of features that the contact names; nullopt if they are no features of bodies a and b.
std::optional<exact::FeaturePair> features_of(const FirstContact& contact, const MeshShape& a, const MeshShape& b) {
    const auto is_of = [](const Feature& feature, const MeshShape& shape) {
        return feature.kind != Feature::Kind::none && feature.corner < 3 &&
               feature.triangle < shape.mesh().triangles().size();
    };
    if (contact.kind > ClosestKind::edge_edge || !is_of(contact.a, a) || !is_of(contact.b, b)) return std::nullopt;
    const exact::FeaturePair features = exact::features_named(contact);
    FirstContact named;
    exact::name_features(named, features, contact.triangles());
    const bool is_same = named.a == contact.a && named.b == contact.b;
    return is_same ? std::optional(features) : std::nullopt;
}

template <class Points>
Integer coordinate(const Points& points, std::size_t i, std::size_t origin, std::size_t axis) {
    return Integer(points.at[i][axis]) - Integer(points.at[origin][axis]);
}

std::optional<MeetingPlace> find_place(const TurnLeg& leg, const MeshShape& a, const Posed<MeshShape>& b,
                                       const FirstContact& contact, const exact::FeaturePair& features) {
    const exact::TurnIntegers turn(leg.from, leg.to);
    const TriangleCorners corners = corners_of(a.mesh(), contact.a.triangle, b.what->mesh(), contact.b.triangle);
    return exact::with_integers(points_of(leg, b.pose, corners), [&](const auto& points) {
        exact::TurningTriangles triangles(points, turn);
        exact::SecondCorners second{
            {}, Polynomial(Polynomial::Coefficients{turn.n[0], turn.n[1], turn.n[2]}), points.unit};
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                second.at[j][k] = Polynomial(coordinate(points, 3 + j, origin_index, k),
                                             coordinate(points, origin_index + 1, origin_index, k));
            }
        }
        return exact::find_meeting_place(triangles, second, features, contact.time);
    });
}

std::optional<MeetingPlace> find_place(const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                                       const FirstContact& contact, const exact::FeaturePair& features) {
    static const Pose world;
    static const Vec3 zero = Vec3::Zero();
    constexpr std::size_t origin = 12;
    const TriangleCorners corners = corners_of(a.what->mesh(), contact.a.triangle, b.what->mesh(), contact.b.triangle);
    exact::PosedPoints<13> posed;
    for (std::size_t i = 0; i < 3; ++i) {
        posed[i] = {&a.from, corners.a[i]};
        posed[3 + i] = {&b.from, corners.b[i]};
        posed[6 + i] = {&a.to, corners.a[i]};
        posed[9 + i] = {&b.to, corners.b[i]};
    }
    posed[origin] = {&world, &zero};
    return exact::with_integers(posed, [&](const auto& points) {
        exact::MovingTriangles triangles(points);
        exact::SecondCorners second{{}, Polynomial(Integer(std::int64_t{1}), {}), points.unit};
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Integer start = coordinate(points, 3 + j, origin, k);
                second.at[j][k] = Polynomial(start, coordinate(points, 9 + j, origin, k) - start);
            }
        }
        return exact::find_meeting_place(triangles, second, features, contact.time);
    });
}

// Returns the contact point of two bodies, which have the poses of `a` and `b` at time 0. If the contact is after time
// 0, calls find(features), which must return the place where the features meet, or nullopt.
template <class Find>
ContactPoint answer(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const FirstContact& contact, const Ask& ask,
                    const Find& find) {
    if (contact.kind == ClosestKind::intersecting || contact.kind == ClosestKind::contained) {
        return {closest(a, b, ask).point_b, {}};
    }
    const auto features = features_of(contact, *a.what, *b.what);
    if (!features) throw NotSupported("contact_point: the contact does not name features of these bodies");
    const std::optional<MeetingPlace> place = find(*features);
    if (!place) throw NotSupported("contact_point: the features do not meet first at the contact's time");
    return {place->point, place->normal};
}

}  // namespace

ContactPoint contact_point(const Turning<MeshShape>& a, const Posed<MeshShape>& b, const FirstContact& contact,
                           const Ask& ask) {
    return contact_point(a, Vec3::Zero(), b, contact, ask);
}

ContactPoint contact_point(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                           const FirstContact& contact, const Ask& ask) {
    validate(a.turn);
    validate_motion(motion_of_b);
    const TurnLeg leg = leg_of(a.pose, a.turn, motion_of_b);
    return answer({*a.what, a.pose}, b, contact, ask,
                  [&](const auto& features) { return find_place(leg, *a.what, b, contact, features); });
}

ContactPoint contact_point(const Way<MeshShape>& a, const Posed<MeshShape>& b, const WayContact& met, const Ask& ask) {
    validate(a.nodes);
    const bool is_after_start = met.contact.kind <= ClosestKind::edge_edge;
    if (met.leg + 1 >= a.nodes.size() || (met.leg > 0 && !is_after_start)) {
        throw NotSupported("contact_point: the way has no such contact on this leg");
    }
    const TurnLeg leg = leg_of(a.pose, a.nodes, met.leg);
    return answer({*a.what, a.pose}, b, met.contact, ask,
                  [&](const auto& features) { return find_place(leg, *a.what, b, met.contact, features); });
}

ContactPoint contact_point(const Moving<MeshShape>& a, const Moving<MeshShape>& b, const FirstContact& contact,
                           const Ask& ask) {
    return answer({*a.what, a.from}, {*b.what, b.from}, contact, ask,
                  [&](const auto& features) { return find_place(a, b, contact, features); });
}

}  // namespace ecods
