// Implements distance.hpp. A query about solids first searches their boundaries. Two convex solids have a search of
// their own, which returns features of the convex sets.
#include "ecods/distance.hpp"

#include <limits>
#include <optional>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "base/next.hpp"
#include "ecods/intersection.hpp"
#include "query/body/contained.hpp"
#include "query/body/core_distance.hpp"
#include "query/convex/solid_pair.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

// Returns the point R v + t, rounded once. It is computed as the closest point of a body that consists of this point.
Vec3 round_point(const Vec3& v, const Pose& pose, QueryMemory& memory) {
    const MeshShape point(Mesh::create({v}, {Triangle{0, 0, 0}}));
    const Posed<MeshShape> body(point, pose);
    return as_part(memory, [&] { return surface::closest(body, body, memory); }).point_a;
}

// Returns the closest points if a part of one body is inside the other one; otherwise nullopt. Both closest points are
// the same point of that part.
std::optional<ClosestPoints> closest_of_contained(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                  const BodyPairAsked& bodies, QueryMemory& memory) {
    const std::optional<ContainedFeatures> features = find_contained(bodies, memory);
    if (!features) return std::nullopt;
    const Posed<MeshShape>& body = features->is_of_a() ? a : b;
    const Feature& vertex = features->is_of_a() ? features->a : features->b;
    const Mesh& mesh = body.what->mesh();
    const Triangle& corners = mesh.triangles()[vertex.triangle];
    const Vec3 point = round_point(mesh.vertices()[corners[vertex.corner]], body.pose, memory);
    return ClosestPoints{0, ClosestKind::contained, features->a, features->b, point, point};
}

// Returns the two doubles next to the rounded distance. If this interval is wider than the tolerance, returns two
// adjacent doubles with the real distance between them.
DistanceBounds bounds_of_convex(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                const DistanceTolerance& tolerance, QueryMemory& memory, PairWitness& witness) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nearest = convex::distance(a, b, memory, witness);
    if (key_of(nearest) == 0) return {0, 0};
    if (key_of(nearest) == infinity_key) return {std::numeric_limits<double>::max(), infinity};
    const DistanceBounds beside{next_down(nearest), next_up(nearest)};
    if (surface::is_narrow(beside, tolerance)) return beside;
    const bool is_above = convex::within(a, b, exact::Limit{exact::ExactSum(nearest)}, memory, witness);
    return is_above ? DistanceBounds{next_down(nearest), nearest} : DistanceBounds{nearest, next_up(nearest)};
}

}  // namespace

double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return cores::distance(a, b, {}, ask);
}

double cores::distance(const Core& a, const Core& b, const exact::ExactSum& margin, const Ask& ask) {
    const bool has_margin = margin.sign() != 0;
    const auto between = [&](const Core& x, const Core& y, const Ask& how) {
        return has_margin ? surface::distance_beyond(x, y, margin, how) : surface::distance(x, y, how);
    };
    if (are_surfaces(*a.what, *b.what)) return between(a, b, ask);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    PairWitness& witness = asking.witness();
    const BodyPairAsked bodies(a, b);
    return as_one_query(memory, [&]() -> double {
        if (bodies.are_convex()) {
            const Posed<ConvexSolid> x = bodies.a.convex(), y = bodies.b.convex();
            return has_margin ? convex::distance_beyond(x, y, margin, memory, witness)
                              : convex::distance(x, y, memory, witness);
        }
        if (is_part_inside(bodies, memory)) return 0;
        return between(bodies.a.boundary(), bodies.b.boundary(), {memory, witness});
    });
}

// Returns true if the real distance is at most max_distance. Infinity is recognized by its key (base/double_key.hpp),
// without a comparison of doubles.
bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance, const Ask& ask) {
    require_distance(max_distance);
    if (key_of(max_distance) == infinity_key) return true;
    return cores::within(a, b, exact::Limit{max_distance}, ask);
}

bool cores::within(const Core& a, const Core& b, const exact::Limit& limit, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::within(a, b, limit, ask);
    if (limit.sum.sign() == 0) return !limit.is_strict && intersects(a, b, ask);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    PairWitness& witness = asking.witness();
    const BodyPairAsked bodies(a, b);
    return as_one_query(memory, [&] {
        if (bodies.are_convex()) {
            return convex::within(bodies.a.convex(), bodies.b.convex(), limit, memory, witness);
        }
        return surface::within(bodies.a.boundary(), bodies.b.boundary(), limit, {memory, witness}) ||
               is_part_inside(bodies, memory);
    });
}

ClosestPoints closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return cores::closest(a, b, {}, ask);
}

ClosestPoints cores::closest(const Core& a, const Core& b, const exact::Radii& radii, const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::closest(a, b, ask, radii);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a, b);
    return as_one_query(memory, [&] {
        if (bodies.are_convex()) {
            if (const auto points =
                    convex::closest(bodies.a.convex(), bodies.b.convex(), memory, asking.witness(), radii)) {
                return *points;
            }
        }
        if (const auto points = closest_of_contained(a, b, bodies, memory)) return *points;
        ClosestPoints points =
            surface::closest(bodies.a.boundary(), bodies.b.boundary(), {memory, asking.witness()}, radii);
        bodies.rename(points);
        return points;
    });
}

DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const DistanceTolerance& tolerance,
                               const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::distance_bounds(a, b, tolerance, ask);
    surface::require_valid(tolerance);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a, b);
    return as_one_query(memory, [&] {
        if (bodies.are_convex()) {
            return bounds_of_convex(bodies.a.convex(), bodies.b.convex(), tolerance, memory, asking.witness());
        }
        if (is_part_inside(bodies, memory)) return DistanceBounds{0, 0};
        return surface::distance_bounds(bodies.a.boundary(), bodies.b.boundary(), tolerance,
                                        {memory, asking.witness()});
    });
}

std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance,
                                           const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::close_triangles(a, b, max_distance, ask);
    const BodyPairAsked bodies(a, b);
    auto found = surface::close_triangles(bodies.a.boundary(), bodies.b.boundary(), max_distance, ask);
    for (ClosestPoints& points : found) bodies.rename(points);
    return found;
}

std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance,
                                          const Ask& ask) {
    if (are_surfaces(*a.what, *b.what)) return surface::close_features(a, b, max_distance, ask);
    const BodyPairAsked bodies(a, b);
    auto found = surface::close_features(bodies.a.boundary(), bodies.b.boundary(), max_distance, ask);
    for (CloseFeatures& features : found) bodies.rename(features.closest);
    return found;
}

}  // namespace ecods
