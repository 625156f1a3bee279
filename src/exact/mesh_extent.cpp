#include "exact/mesh_extent.hpp"

namespace ecods::exact {

MeshExtent measure(const Mesh& mesh) {
    const auto vertices = mesh.vertices();
    const Vec3& first = vertices[mesh.triangles().front()[0]];
    MeshExtent extent{first, first, {}};
    for (const Triangle& triangle : mesh.triangles()) {
        for (const std::uint32_t index : triangle) {
            const Vec3& v = vertices[index];
            extent.min = extent.min.cwiseMin(v);
            extent.max = extent.max.cwiseMax(v);
            for (int axis = 0; axis < 3; ++axis) {
                extent.digits[static_cast<std::size_t>(axis)].include(decode(v[axis]));
            }
        }
    }
    return extent;
}

}  // namespace ecods::exact
