// One MeshShape, and so one tree, for all bodies of a mesh while any of them lives.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>

#include "ecods/shape.hpp"

namespace ecods {

class MeshShapes {
  public:
    // Makes it where it is not known. Throws NullArgument.
    std::shared_ptr<const MeshShape> shape_of(const std::shared_ptr<const Mesh>& mesh);

    std::shared_ptr<const MeshShape> find(const std::shared_ptr<const Mesh>& mesh) const;  // or null

  private:
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> shapes_;
    std::size_t size_max_ = 16;  // when that many are known, those that are gone are forgotten
};

}  // namespace ecods
