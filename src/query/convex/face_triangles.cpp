#include "query/convex/face_triangles.hpp"

#include <algorithm>
#include <array>

#include "query/convex/convex_parts.hpp"
#include "query/convex/hull_features.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods::convex {

FaceTriangles::FaceTriangles(const ConvexSolid& solid) {
    const Hull& hull = ConvexSolidAccess::hull(solid);
    const SolidAccess::Parts& parts = SolidAccess::parts(solid);
    const Mesh& mesh = solid.mesh();
    if (hull.faces.empty() || hull.vertex_count() != mesh.vertices().size() || !parts.has_area.empty() ||
        !parts.origins.empty()) {
        return;
    }
    const std::vector<std::uint32_t>& vertex_of = ConvexSolidAccess::points(solid).hull_index;
    const auto triangles = mesh.triangles();
    std::vector<std::uint32_t> faces(triangles.size()), first(hull.faces.size() + 1, 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        faces[i] = face_of(hull, {vertex_of[a], vertex_of[b], vertex_of[c]});
        if (faces[i] == Hull::no_face) return;
        ++first[faces[i] + 1];
    }
    for (std::size_t f = 0; f + 1 < first.size(); ++f) first[f + 1] += first[f];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    triangles_.resize(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) triangles_[next[faces[i]]++] = i;
    first_ = std::move(first);
}

}  // namespace ecods::convex
