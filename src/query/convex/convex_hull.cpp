#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/make_error.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "geometry/find_invalid.hpp"
#include "query/convex/convexity.hpp"
#include "query/convex/hull_build.hpp"
#include "query/convex/hull_of_points.hpp"
#include "query/solid/flat_mesh.hpp"

namespace ecods {
namespace {

using namespace convex;

Hull hull_of(std::span<const Vec3> points, std::vector<Triangle> border_triangles) {
    const ProperMesh proper{Mesh::create({points.begin(), points.end()}, std::move(border_triangles)), {}};
    const MeshEdges edges(proper);
    const Border border{&proper, &edges, {}, &proper, {}, exact::VertexSigns(proper.mesh->vertices())};
    Shells shells;
    shells.first = {0};
    return build_hull(border, require_convex(border, shells, *proper.mesh));
}

}  // namespace

std::shared_ptr<const Mesh> convex_hull(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!is_finite(points[i][axis])) throw invalid_vertex(i, axis, points[i][axis]);
        }
    }
    if (points.size() > std::numeric_limits<std::uint32_t>::max()) throw mesh_too_large(points.size(), 0);
    if (points.empty()) throw no_interior(0);
    std::vector<Triangle> border = triangulate_hull(points);
    if (border.empty()) return mesh_of_flat(points, *flat_hull(points, distinct(points)));
    const Hull hull = hull_of(points, std::move(border));

    std::vector<std::uint32_t> kept = hull.mesh_vertices;
    std::ranges::sort(kept);
    std::vector<Vec3> vertices;
    for (const std::uint32_t i : kept) vertices.push_back(points[i]);
    const auto index_of = [&](const Hull::Neighbor& corner) {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(kept, hull.mesh_vertices[corner.vertex]) -
                                          kept.begin());
    };
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> cycle;
    for (std::uint32_t face = 0; face < hull.faces.size(); ++face) {
        cycle.clear();
        for (const Hull::Neighbor& corner : hull.cycle_of(face)) cycle.push_back(index_of(corner));
        std::ranges::rotate(cycle, std::ranges::min_element(cycle));
        for (std::size_t k = 1; k + 1 < cycle.size(); ++k) triangles.push_back({cycle[0], cycle[k], cycle[k + 1]});
    }
    std::ranges::sort(triangles);
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace ecods
