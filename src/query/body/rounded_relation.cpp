// Computes the relation of two bodies with radii r and s around cores A and B; at least one radius is positive.
//
// Let D be the distance of the cores. At D = r + s > 0 the bodies touch: a common point x is on a segment from A to B
// of length r + s, at distance r from A. If s > 0, points of the segment beyond x are further than r from A, so x is no
// inner point of the first body; if r > 0, the same holds for the second. If s = 0, x is a point of B at a positive
// distance from A, and no inner point of B either: points of the segment before x are nearer to A. At D < r + s a point
// is within less than r and s of both cores, or of the core without a radius, and inner points of the rest are near it.
//
// Subsets. A + r is in B + s, of which the core B is convex or s = 0:
//
//  - If r <= s, if and only if each vertex of A is within s - r of B. (B + (s - r) is closed and convex. If it contains
//    the vertices of A, it contains A, and so B + s contains A + r. If a vertex lies outside, there is a plane with
//    this vertex on one side and B + (s - r) on the other; shifted by r, it parts a point of A + r from B + s.)
//  - If r > s, if and only if A is in B and no nearer than r - s to the boundary of B, so B must have inner points.
//    (By the same planes, A + r is in B + s if A + (r - s) is in B. The ball around a point of B is in B if no point of
//    the boundary is inside the ball.) A is connected, since a core with a radius is convex here; so one vertex of A
//    shows if A is in B.
#include <array>
#include <cstdint>
#include <memory>

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "geometry/used_vertices.hpp"
#include "query/body/core_distance.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/intersection/asking.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/relations.hpp"

namespace ecods {
namespace {

bool is_positive(double radius) noexcept {
    return key_of(radius) > 0;
}

bool has_inside(const CoreAndRadius& body) {
    return is_positive(body.radius) || PosedBody(body.core).has_inside();
}

// Returns true unless the body has a radius and a core that is not convex. For such a body it is never decided whether
// the body contains another one.
bool may_contain(const CoreAndRadius& body) noexcept {
    return !is_positive(body.radius) || body.kind == ShapeKind::rounded_convex();
}

// Returns the vertex of the body's core as a posed point.
Posed<MeshShape> point_of(const Posed<MeshShape>& core, std::uint32_t vertex) {
    auto point =
        std::make_shared<const MeshShape>(Mesh::create({core.what->mesh().vertices()[vertex]}, {Triangle{0, 0, 0}}));
    return {std::move(point), core.pose};
}

// Returns true if the inner body is a subset of the outer one, which has a convex core or no radius.
bool is_inside(const CoreAndRadius& inner, const CoreAndRadius& outer, const Ask& ask) {
    const exact::ExactSum rest = exact::ExactSum(outer.radius).minus(inner.radius);
    const PosedBody part(inner.core);
    const MeshShape& shape = *part.boundary().what;
    const auto has = [&](std::uint32_t vertex) {
        const Posed<MeshShape> point = point_of(part.boundary(), vertex);
        return cores::within(point, outer.core, exact::Limit{rest.sign() > 0 ? rest : exact::ExactSum()}, ask);
    };
    if (rest.sign() >= 0) {
        bool are_all = true;
        for_each_used_vertex(shape.mesh(), [&](std::uint32_t vertex) { are_all = are_all && has(vertex); });
        return are_all;
    }
    const PosedBody body(outer.core);
    if (!body.has_inside()) return false;
    const MeshShape& boundary = *body.boundary().what;
    const auto surface = MeshShapeAccess::surface(boundary);
    if (cores::within(inner.core, {*surface, outer.core.pose}, exact::Limit{-rest, true}, ask)) return false;
    return has(shape.mesh().triangles()[0][0]);
}

}  // namespace

Relation RoundedPair::relation(const Ask& ask) const {
    const exact::ExactSum sum = radii().sum();
    if (sum.sign() == 0) return ecods::relation(a.core, b.core, ask);
    Asking asking(ask);
    const Ask in_memory(asking.memory(), asking.witness());
    const std::optional<int> sign = filtered(0, in_memory);
    const auto is_within = [&](bool is_strict) {
        return sign ? *sign < 0 : cores::within(a.core, b.core, exact::Limit{sum, is_strict}, in_memory);
    };
    if (!is_within(false)) return Relation::apart;
    if (!is_within(true)) return Relation::touching;
    if (!may_contain(a) || !may_contain(b)) throw NotSupported(Question::relation, a.kind, b.kind);
    const Ask only_memory(asking.memory());
    const bool is_in_b = has_inside(b) && is_inside(a, b, only_memory);
    const bool is_in_a = has_inside(a) && is_inside(b, a, only_memory);
    if (!has_inside(a)) return is_in_b ? Relation::inside : Relation::crossing;
    if (!has_inside(b)) return is_in_a ? Relation::contains : Relation::crossing;
    if (is_in_a && is_in_b) return Relation::equal;
    return is_in_b ? Relation::inside : is_in_a ? Relation::contains : Relation::overlapping;
}

}  // namespace ecods
