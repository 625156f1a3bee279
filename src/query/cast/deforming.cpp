#include "query/cast/deforming.hpp"

#include <cstdint>
#include <utility>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "bvh/tree/moving_tree.hpp"
#include "exact/point/mesh_extent.hpp"
#include "geometry/used_vertices.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

std::shared_ptr<const Mesh> with_triangles_of(const std::shared_ptr<const MeshShape>& shape,
                                              std::vector<Vec3> vertices) {
    if (!shape) throw null_argument("shape");
    const auto triangles = shape->mesh().triangles();
    return Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()});
}

// Returns the box of the vertices of both meshes. Each vertex moves on a straight line, so it stays in the box.
// Compares keys, because the processor may take subnormal numbers for zero.
Aabb box_of_ends(const Mesh& start, const Mesh& end) {
    const std::uint32_t first = start.triangles().front()[0];
    Aabb box{start.vertices()[first], start.vertices()[first]};
    for (const Mesh* const mesh : {&start, &end}) {
        for_each_used_vertex(*mesh, [&](std::uint32_t index) {
            const Vec3& v = mesh->vertices()[index];
            for (int k = 0; k < 3; ++k) {
                if (key_of(v[k]) < key_of(box.min[k])) box.min[k] = v[k];
                if (key_of(v[k]) > key_of(box.max[k])) box.max[k] = v[k];
            }
        });
    }
    return box;
}

}  // namespace

struct Deforming::Parts {
    Parts(std::shared_ptr<const MeshShape> start, std::vector<Vec3> vertices_at_end)
        : end(with_triangles_of(start, std::move(vertices_at_end))),
          extent_at_end(exact::measure(*end)),
          tree_at_end(with_other_vertices(MeshShapeAccess::tree(*start).boxes, *end)),
          shape(std::move(start)),
          surface(shape->form() == MeshForm::surface ? shape : MeshShapeAccess::surface(*shape)),
          at_start(*surface, Pose()),
          box(box_of_ends(shape->mesh(), *end)) {}

    std::shared_ptr<const Mesh> end;
    exact::MeshExtent extent_at_end;
    MeshBvh tree_at_end;
    std::shared_ptr<const MeshShape> shape;
    std::shared_ptr<const MeshShape> surface;  // shares the tree of the shape
    Posed<MeshShape> at_start;
    Pose pose_at_end;
    Aabb box;
};

Deforming::Deforming(std::shared_ptr<const MeshShape> shape, std::vector<Vec3> vertices_at_end)
    : parts_(std::make_shared<const Parts>(std::move(shape), std::move(vertices_at_end))) {}

const std::shared_ptr<const MeshShape>& Deforming::shape() const noexcept {
    return parts_->shape;
}
const Mesh& Deforming::mesh_at_end() const noexcept {
    return *parts_->end;
}
const Aabb& Deforming::box() const noexcept {
    return parts_->box;
}

const Posed<MeshShape>& DeformingAccess::at_start(const Deforming& mesh) {
    return mesh.parts_->at_start;
}
MeshAtEnds DeformingAccess::at_ends(const Deforming& mesh) {
    const Deforming::Parts& parts = *mesh.parts_;
    return {parts.at_start, {parts.end.get(), &parts.extent_at_end, &parts.pose_at_end}, parts.tree_at_end};
}

}  // namespace ecods
