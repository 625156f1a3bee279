#include "world/moved_boxes.hpp"

#include <span>
#include <typeinfo>

#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// Returns the shape as a mesh if its box() is the library's own; otherwise null, because a caller's derived class may
// override box().
const MeshShape* as_own_mesh(const Shape& shape) {
    const std::type_info& type = typeid(shape);
    const bool is_own = type == typeid(MeshShape) || type == typeid(Solid) || type == typeid(ConvexSolid);
    return is_own ? static_cast<const MeshShape*>(&shape) : nullptr;
}

}  // namespace

bool MovedBoxes::add(const Shape& shape, const Pose& pose, std::size_t index) {
    // Hashes the address. The shifts drop its lowest bits, which hardly differ: shapes are some hundred bytes apart.
    const auto address = reinterpret_cast<std::uintptr_t>(&shape);
    Batch& batch = batches_[(address >> 4 ^ address >> 7) % batches_.size()];
    if (batch.shape != &shape) {
        find(batch);
        batch.shape = &shape;
        batch.mesh = as_own_mesh(shape);
    }
    if (batch.mesh == nullptr) return false;
    batch.poses[batch.count] = &pose;
    batch.indices[batch.count] = index;
    if (++batch.count == batch_size) find(batch);
    return true;
}

void MovedBoxes::finish() {
    for (Batch& batch : batches_) find(batch);
}

void MovedBoxes::find(Batch& batch) {
    if (batch.count == 0) return;
    std::array<Aabb*, batch_size> boxes;
    for (std::size_t i = 0; i < batch.count; ++i) boxes[i] = &boxes_[batch.indices[i]];
    MeshShapeAccess::find_boxes(*batch.mesh, std::span(batch.poses).first(batch.count),
                                std::span(boxes).first(batch.count));
    batch.count = 0;
}

}  // namespace ecods
