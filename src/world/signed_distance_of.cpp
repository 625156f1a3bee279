#include "world/signed_distance_of.hpp"

#include <utility>

#include "base/double_key.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "query/convex/convex_core.hpp"
#include "query/convex/solid_pair.hpp"
#include "world/rounded_test.hpp"

namespace ecods {
namespace {

const ConvexSolid* as_convex(const Shape& shape) noexcept {
    if (shape.kind() != ShapeKind::mesh()) return nullptr;
    const auto& mesh = static_cast<const MeshShape&>(shape);
    return mesh.form() == MeshForm::convex ? static_cast<const ConvexSolid*>(&mesh) : nullptr;
}

bool is_half_space(const Posed<Shape>& posed) noexcept {
    return posed.what->kind() == ShapeKind::half_space();
}

bool is_mesh(const Posed<Shape>& posed) noexcept {
    return posed.what->kind() == ShapeKind::mesh();
}

// Returns true if one of the two bodies is a half space, and the other one is a mesh or a rounded body.
bool have_half_space(const Posed<Shape>& a, const Posed<Shape>& b) {
    return is_half_space(a) ? core_and_radius(b).has_value() : is_half_space(b) && core_and_radius(a).has_value();
}

SignedDistance from_half_space(const Posed<Shape>& body, const Posed<Shape>& other, const Ask& ask) {
    const Posed<HalfSpace> half_space(static_cast<const HalfSpace&>(*other.what), other.pose);
    if (is_mesh(body)) {
        return signed_distance(Posed<MeshShape>(static_cast<const MeshShape&>(*body.what), body.pose), half_space, ask);
    }
    return signed_distance(Posed<Rounded>(static_cast<const Rounded&>(*body.what), body.pose), half_space, ask);
}

// Returns true if the core is convex and its pose is regular. Two cores for which is_convex() returns true have a
// depth.
bool is_convex(const CoreAndRadius& body) {
    return convex::is_convex_core(*body.core.what) && convex::is_regular(body.core.pose);
}

std::optional<RoundedPair> as_convex_rounded_pair(const Posed<Shape>& a, const Posed<Shape>& b) {
    const auto pair = as_rounded_pair(a, b);
    return pair && is_convex(pair->a) && is_convex(pair->b) ? pair : std::nullopt;
}

}  // namespace

std::optional<RoundedPair> as_rounded_pair(const Posed<Shape>& a, const Posed<Shape>& b) {
    if (is_mesh(a) && is_mesh(b)) return std::nullopt;
    const auto first = core_and_radius(a), second = core_and_radius(b);
    return first && second ? std::optional(RoundedPair{*first, *second}) : std::nullopt;
}

std::optional<ConvexSolids> as_convex_solids(const Posed<Shape>& a, const Posed<Shape>& b) {
    const ConvexSolid *const first = as_convex(*a.what), *const second = as_convex(*b.what);
    if (first == nullptr || second == nullptr || !convex::is_regular(a.pose) || !convex::is_regular(b.pose)) {
        return std::nullopt;
    }
    return ConvexSolids{{*first, a.pose}, {*second, b.pose}};
}

bool have_signed_distance(const Posed<Shape>& a, const Posed<Shape>& b) {
    return have_half_space(a, b) || as_convex_solids(a, b) || as_convex_rounded_pair(a, b);
}

void turn(SignedDistance& found) noexcept {
    std::swap(found.a, found.b);
    std::swap(found.point_a, found.point_b);
    for (double& x : found.direction) x = opposite(x);
}

std::optional<SignedDistance> signed_distance_of(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) {
    if (const auto convex = as_convex_solids(a, b)) return signed_distance(convex->a, convex->b, ask);
    if (const auto rounded = as_convex_rounded_pair(a, b)) return rounded->signed_distance(ask);
    if (!have_half_space(a, b)) return std::nullopt;
    if (is_half_space(b)) return from_half_space(a, b, ask);
    SignedDistance found;
    try {
        found = from_half_space(b, a, ask);
    } catch (const SingularPose&) {
        throw SingularPose(0);
    }
    turn(found);
    return found;
}

}  // namespace ecods
