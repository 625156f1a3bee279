#include "query/certificate/closest_axis.hpp"

namespace ecods {
namespace {

using Kind = AxisFormula::Kind;

// The corner by which a triangle names a feature; 0 of a face.
std::uint8_t corner_of(const FeatureKey& feature, std::uint32_t triangle, const Mesh& mesh) {
    return static_cast<std::uint8_t>(feature_of(feature, triangle, mesh.triangles()[triangle]).corner);
}

}  // namespace

AxisFormula formula_of(const DistanceInterval& interval, const Posed<MeshShape>& body_a, std::uint32_t of_a,
                       const Posed<MeshShape>& body_b, std::uint32_t of_b) {
    const std::uint8_t i = corner_of(interval.a, of_a, body_a.what->mesh()),
                       j = corner_of(interval.b, of_b, body_b.what->mesh());
    switch (interval.kind) {
        case ClosestKind::vertex_vertex:
            return {Kind::vertices, i, j};
        case ClosestKind::vertex_edge:
            return interval.a.is_vertex() ? AxisFormula{Kind::vertex_a_edge, i, j}
                                          : AxisFormula{Kind::vertex_b_edge, j, i};
        case ClosestKind::vertex_face:
            return {interval.a.is_vertex() ? Kind::normal_b : Kind::normal_a};
        default:
            return {Kind::edges, i, j};
    }
}

// The axis along which a pair of triangles is as far apart as it is.
AxisFormula formula_of(const ClosestPoints& closest) {
    const auto i = static_cast<std::uint8_t>(closest.a.corner), j = static_cast<std::uint8_t>(closest.b.corner);
    switch (closest.kind) {
        case ClosestKind::vertex_vertex:
            return {Kind::vertices, i, j};
        case ClosestKind::vertex_edge:
            return closest.a.kind == Feature::Kind::vertex ? AxisFormula{Kind::vertex_a_edge, i, j}
                                                           : AxisFormula{Kind::vertex_b_edge, j, i};
        case ClosestKind::vertex_face:
            return {closest.a.kind == Feature::Kind::face ? Kind::normal_a : Kind::normal_b};
        default:
            return {Kind::edges, i, j};
    }
}

Vec3 direction_along(const AxisFormula& f, const Posed<MeshShape>& body_a, std::uint32_t of_a,
                     const Posed<MeshShape>& body_b, std::uint32_t of_b) {
    const Mesh &mesh_a = body_a.what->mesh(), &mesh_b = body_b.what->mesh();
    const Triangle &a = mesh_a.triangles()[of_a], &b = mesh_b.triangles()[of_b];
    const auto at_a = [&](std::size_t c) -> Vec3 { return body_a.pose.R * mesh_a.vertices()[a[c % 3]]; };
    const auto at_b = [&](std::size_t c) -> Vec3 {
        return body_b.pose.R * mesh_b.vertices()[b[c % 3]] + (body_b.pose.t - body_a.pose.t);
    };
    const auto across = [](const Vec3& w, const Vec3& e) -> Vec3 { return e.dot(e) * w - w.dot(e) * e; };
    switch (f.kind) {
        case Kind::normal_a:
            return ((at_a(1) - at_a(0)).cross(at_a(2) - at_a(0)));
        case Kind::normal_b:
            return ((at_b(1) - at_b(0)).cross(at_b(2) - at_b(0)));
        case Kind::edges:
            return ((at_a(f.i + 1) - at_a(f.i)).cross(at_b(f.j + 1) - at_b(f.j)));
        case Kind::vertex_a_edge:
            return (across(at_a(f.i) - at_b(f.j), at_b(f.j + 1) - at_b(f.j)));
        case Kind::vertex_b_edge:
            return (across(at_b(f.i) - at_a(f.j), at_a(f.j + 1) - at_a(f.j)));
        default:
            return (at_b(f.j) - at_a(f.i));
    }
}

}  // namespace ecods
