// This file computes the point and the normal of the first contact of two rounded bodies, one of which is translated.
//
// The bodies touch when the distance of their cores is p, the sum of the radii. The closest points x and y of the cores
// then have the distance p, so the bodies share the one point of the segment xy that is at the radii from its ends, and
// the normal is along the segment. The exact time is computed again, from the two triangles that the contact names.
#include "query/patch/rounded_contact_point.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "exact/measure/contact/rounded_contact.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/point/posed_point.hpp"
#include "geometry/feature_key.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

[[noreturn]] void refuse() {
    throw NotSupported("contact_point: the contact is not the first one of these bodies and this motion");
}

// Throws NotSupported unless the contact names features of both meshes.
void require_features(const RoundedPair& bodies, const FirstContact& contact) {
    const auto is_of = [](const Feature& feature, const Posed<MeshShape>& core) {
        return feature.kind != Feature::Kind::none && feature.corner < 3 &&
               feature.triangle < core.what->mesh().triangles().size();
    };
    if (contact.kind > ClosestKind::edge_edge || !is_of(contact.a, bodies.a.core) || !is_of(contact.b, bodies.b.core)) {
        refuse();
    }
}

std::array<exact::ScaledLongVector, 6> corners_of(const RoundedPair& bodies, const TrianglePair& pair) {
    std::array<exact::ScaledLongVector, 6> corners;
    const auto put = [&](const Posed<MeshShape>& core, std::uint32_t triangle, std::size_t first) {
        const Mesh& mesh = core.what->mesh();
        for (std::size_t i = 0; i < 3; ++i) {
            corners[first + i] = exact::posed_point(core.pose, mesh.vertices()[mesh.triangles()[triangle][i]]);
        }
    };
    put(bodies.a.core, pair.a, 0);
    put(bodies.b.core, pair.b, 3);
    return corners;
}

// Returns the exact time of the contact. Throws NotSupported if the triangles that the contact names have no such
// contact.
exact::RootSum time_of(const exact::RoundedContact& triangles, const FirstContact& contact) {
    auto times = triangles.interval();
    if (!times || key_of(times->first.rounded) != key_of(contact.time)) refuse();
    FeatureNames names;
    exact::name_features(names, times->first.features, contact.triangles());
    if (names != FeatureNames{contact.kind, contact.a, contact.b}) refuse();
    return std::move(times->first.time);
}

}  // namespace

ContactPoint contact_point(const RoundedPair& bodies, const Vec3& motion, const FirstContact& contact, const Ask& ask) {
    const exact::ExactSum p = bodies.radii().sum();
    if (p.sign() == 0) return contact_point(bodies.a.core, motion, bodies.b.core, contact, ask);
    validate_motion(motion);
    const bool is_at_start = key_of(contact.time) == 0;
    if (is_at_start) {
        const ClosestPoints closest = bodies.closest(ask);
        const bool is_same =
            FeatureNames{closest.kind, closest.a, closest.b} == FeatureNames{contact.kind, contact.a, contact.b};
        if (!is_same || key_of(closest.distance) != 0) refuse();
        if (closest.kind > ClosestKind::edge_edge) return {closest.point_b, std::nullopt};
    }
    require_features(bodies, contact);
    const exact::ScaledLongVector step = exact::exact_vector(motion);
    const exact::RoundedContact triangles(corners_of(bodies, contact.triangles()), step, p);
    if (!is_at_start && exact::is_zero(step)) refuse();
    const exact::RootSum time = is_at_start ? exact::RootSum() : time_of(triangles, contact);
    const auto place = triangles.place(exact::features_named(contact), time, exact::ScaledInteger(bodies.a.radius));
    if (!place) refuse();
    return {place->point, is_at_start ? std::nullopt : std::optional(place->normal)};
}

ContactPoint contact_point(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b,
                           const FirstContact& contact, const Ask& ask) {
    return contact_point(RoundedPair{a, b}, motion, contact, ask);
}
ContactPoint contact_point(const Posed<Rounded>& a, const Vec3& motion, const Posed<MeshShape>& b,
                           const FirstContact& contact, const Ask& ask) {
    return contact_point(RoundedPair{a, b}, motion, contact, ask);
}
ContactPoint contact_point(const Posed<MeshShape>& a, const Vec3& motion, const Posed<Rounded>& b,
                           const FirstContact& contact, const Ask& ask) {
    return contact_point(RoundedPair{a, b}, motion, contact, ask);
}

}  // namespace ecods
