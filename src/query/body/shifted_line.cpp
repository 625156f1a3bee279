#include "query/body/shifted_line.hpp"

#include <algorithm>

#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"

namespace ecods {
namespace {

using exact::ScaledInteger;
using exact::ScaledLongVector;

// A SeenEdge is an edge of a triangle, seen along the line: d x e, and the side of the edge on which the line is.
struct SeenEdge {
    ScaledLongVector across;
    int side = 0;

    bool is_point() const noexcept { return exact::is_zero(across); }
    bool is_met() const noexcept { return side == 0 && !is_point(); }
    int side_of_shifted(const ScaledLongVector& shift) const { return side != 0 ? side : dot(across, shift).sign(); }
};
using SeenTriangle = std::array<SeenEdge, 3>;

SeenTriangle see(const Line& line, const ScaledLongVector& direction, const Posed<MeshShape>& body,
                 std::uint32_t triangle) {
    const Mesh& mesh = body.what->mesh();
    const ScaledLongVector begin = exact::exact_vector(line.a);
    std::array<ScaledLongVector, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = exact::posed_point(body.pose, mesh.vertices()[mesh.triangles()[triangle][i]]);
    }
    SeenTriangle seen;
    for (std::size_t i = 0; i < 3; ++i) {
        seen[i].across = cross(direction, minus(corners[(i + 1) % 3], corners[i]));
        seen[i].side = dot(seen[i].across, minus(begin, corners[i])).sign();
    }
    return seen;
}

bool is_in_face(const Hit& hit) noexcept {
    return hit.kind == HitKind::front || hit.kind == HitKind::back;
}

}  // namespace

ScaledLongVector direction_of(const Line& line) {
    const ScaledLongVector b = exact::exact_vector(line.b);
    return line.is_ray ? b : minus(b, exact::exact_vector(line.a));
}

ShiftedLine::ShiftedLine(const Line& line, std::span<const ExactHit> hits, const Posed<MeshShape>& body)
    : shift_(1, 0, 0), crosses_(hits.size(), 1) {
    const ScaledLongVector direction = direction_of(line);
    std::vector<SeenTriangle> seen;
    for (const ExactHit& each : hits) {
        if (!is_in_face(each.hit)) seen.push_back(see(line, direction, body, each.hit.triangle()));
    }
    ScaledLongVector shift = exact::exact_vector(shift_);
    const auto meets_edge = [&](const SeenTriangle& triangle) {
        return std::ranges::any_of(
            triangle, [&](const SeenEdge& edge) { return edge.is_met() && edge.side_of_shifted(shift) == 0; });
    };
    while (std::ranges::any_of(seen, meets_edge)) {
        const double k = shift_[1] + 1;
        shift_ = Vec3(1, k, k * k);
        shift = exact::exact_vector(shift_);
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (is_in_face(hits[i].hit)) continue;
        const SeenTriangle& triangle = seen[at++];
        const int side = triangle[0].side_of_shifted(shift);
        crosses_[i] = std::ranges::all_of(
            triangle, [&](const SeenEdge& edge) { return !edge.is_point() && edge.side_of_shifted(shift) == side; });
    }
}

}  // namespace ecods
