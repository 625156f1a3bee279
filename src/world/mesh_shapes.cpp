#include "world/mesh_shapes.hpp"
#include "base/make_error.hpp"

namespace ecods {

std::shared_ptr<const MeshShape> MeshShapes::shape_of(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh) throw null_argument("mesh");
    if (shapes_.size() >= size_max_) {
        std::erase_if(shapes_, [](const auto& entry) { return entry.second.expired(); });
        size_max_ = 2 * shapes_.size() + 16;
    }
    if (auto shape = find(mesh)) return shape;
    auto shape = std::make_shared<const MeshShape>(mesh);
    shapes_[mesh.get()] = shape;
    return shape;
}

std::shared_ptr<const MeshShape> MeshShapes::find(const std::shared_ptr<const Mesh>& mesh) const {
    const auto known = shapes_.find(mesh.get());
    return known == shapes_.end() ? nullptr : known->second.lock();
}

}  // namespace ecods
