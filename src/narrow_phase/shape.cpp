#include "ecods/shape.hpp"

#include <mutex>
#include <utility>

#include "ecods/error.hpp"
#include "narrow_phase/mesh_tree.hpp"

namespace ecods {

struct MeshShape::LazyTree {
    std::once_flag once;
    Tree tree;
};

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)), lazy_(std::make_unique<LazyTree>()) {
    if (!mesh_) throw NullArgument("mesh");
}

MeshShape::~MeshShape() = default;

Aabb MeshShape::box(const Pose& pose) const {
    return box_of(*mesh_, pose);
}

// The only state behind const: written once under the flag, the same whoever comes first.
const MeshShape::Tree& MeshShape::tree() const {
    std::call_once(lazy_->once, [this] {
        lazy_->tree.extent = exact::measure(*mesh_);
        lazy_->tree.boxes = build_wide_tree(*mesh_);
    });
    return lazy_->tree;
}

std::vector<TrianglePair> TwoBodyTest::touching_triangles(const PosedShape& a, const PosedShape& b,
                                                          QueryMemory& /*memory*/) const {
    throw NotSupported("the test of shape kinds " + std::to_string(a.shape.kind().value) + " and " +
                       std::to_string(b.shape.kind().value) + " has no triangles to list");
}

}  // namespace ecods
