// Shares one MeshShape, and so one tree, among all bodies of a mesh, as long as any of these bodies lives.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>

#include "ecods/shape.hpp"

namespace ecods {

class MeshShapes {
  public:
    // Returns the shape of the mesh, and creates it if no living body has it. Throws InvalidArgument if `mesh` is null.
    std::shared_ptr<const MeshShape> shape_of(const std::shared_ptr<const Mesh>& mesh);

    std::shared_ptr<const MeshShape> find(const std::shared_ptr<const Mesh>& mesh) const;  // null if not known

  private:
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> shapes_;
    std::size_t size_max_ = 16;  // when the map has this many entries, entries of dead shapes are removed
};

}  // namespace ecods
