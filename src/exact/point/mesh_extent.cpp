#include "exact/point/mesh_extent.hpp"

#include "geometry/used_vertices.hpp"

namespace ecods::exact {

MeshExtent measure(const Mesh& mesh) {
    const auto vertices = mesh.vertices();
    Vec3 min = vertices[mesh.triangles().front()[0]];
    Vec3 max = min;
    MeshExtent extent;
    for_each_used_vertex(mesh, [&](std::uint32_t index) {
        const Vec3& v = vertices[index];
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
        for (int axis = 0; axis < 3; ++axis) {
            const Dyadic x = decode(v[axis]);
            extent.digits[static_cast<std::size_t>(axis)].include(x);
            extent.units[static_cast<std::size_t>(axis)].include(x);
        }
    });
    // min and max are halved before they are added, because the sum of two large coordinates may overflow.
    extent.center = 0.5 * min + 0.5 * max;
    extent.half = 0.5 * max - 0.5 * min;
    extent.magnitude = min.cwiseAbs().cwiseMax(max.cwiseAbs());
    return extent;
}

}  // namespace ecods::exact
