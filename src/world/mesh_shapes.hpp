// Shares one MeshShape, and so one tree, among all bodies of a mesh while any of them lives.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>

#include "ecods/shape.hpp"

namespace ecods {

class MeshShapes {
  public:
    // Returns the shape of the mesh, and makes it if it is not known. Throws InvalidArgument for null.
    std::shared_ptr<const MeshShape> shape_of(const std::shared_ptr<const Mesh>& mesh);

    std::shared_ptr<const MeshShape> find(const std::shared_ptr<const Mesh>& mesh) const;  // null: not known

  private:
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> shapes_;
    std::size_t size_max_ = 16;  // when there are this many entries, those of dead shapes are removed
};

}  // namespace ecods
