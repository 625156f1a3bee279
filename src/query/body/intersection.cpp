// Implements intersection.hpp. A query about solids first tests their boundaries.
#include "ecods/intersection.hpp"

#include "query/body/contained.hpp"
#include "query/body/flat_crossing.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {

// Returns true if the bodies share a point. The boundaries are tested first: an axis of the last query, or two
// triangles that met, decides most pairs of solids, and nothing else about the solids is computed. An axis that
// separates the boundaries separates the bodies. Convex solids are treated like others, because a search for the
// distance takes longer (measured).
bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::intersects(a, b, ask);
    Asking asking(ask);
    const Ask boundaries(asking.memory(), asking.witness());
    if (surface::intersects(boundary_of(a), boundary_of(b), boundaries)) return true;
    return !surface::holds_axis(asking.witness()) && is_part_inside({a, b}, asking.memory());
}

namespace {

// Returns the relation of two bodies without insides. A flat set may cross another body although the two sets'
// triangles only touch, if the other body passes through a line between triangles.
Relation flat_relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    const Relation of_triangles =
        surface::relation(boundary_of(a), boundary_of(b), {asking.memory(), asking.witness()});
    if (of_triangles != Relation::touching) return of_triangles;
    const bool is_first = is_flat_set(a);
    if (!is_first && !is_flat_set(b)) return of_triangles;
    const auto cross = [&] { return do_flat_cross(is_first ? a : b, is_first ? b : a, asking.memory()); };
    return as_part(asking.memory(), cross) ? Relation::crossing : Relation::touching;
}

}  // namespace

Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::relation(a, b, ask);
    const bool is_solid_a = has_inside(*a.what), is_solid_b = has_inside(*b.what);
    const auto solid = [](const Posed<MeshShape>& body) {
        return Posed<Solid>(static_cast<const Solid&>(*body.what), body.pose);
    };
    if (is_solid_a && is_solid_b) return solid_relation(solid(a), solid(b), ask);
    if (is_solid_b) return surface_relation(boundary_of(a), solid(b), ask);
    if (is_solid_a) return mirrored(surface_relation(boundary_of(b), solid(a), ask));
    return flat_relation(a, b, ask);
}

std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::intersecting_triangles(a, b, ask);
    const BodyPairAsked bodies(a, b);
    auto pairs = surface::intersecting_triangles(bodies.a.boundary(), bodies.b.boundary(), ask);
    for (TrianglePair& pair : pairs) bodies.rename(pair);
    return pairs;
}

std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::intersections(a, b, ask);
    const BodyPairAsked bodies(a, b);
    auto found = surface::intersections(bodies.a.boundary(), bodies.b.boundary(), ask);
    for (TriangleIntersection& each : found) bodies.rename(each.triangles);
    return found;
}

}  // namespace ecods
