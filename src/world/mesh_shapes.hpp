// One MeshShape, and so one tree, for all bodies of a mesh while any of them lives.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>

#include "base/make_error.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class MeshShapes {
  public:
    // Makes it where it is not known. Throws InvalidArgument.
    std::shared_ptr<const MeshShape> shape_of(const std::shared_ptr<const Mesh>& mesh);

    std::shared_ptr<const MeshShape> find(const std::shared_ptr<const Mesh>& mesh) const;  // or null

    // ask(shape) of the mesh: the one that is known, or one for this time. Throws InvalidArgument.
    template <class Ask>
    auto with(const std::shared_ptr<const Mesh>& mesh, const Ask& ask) const {
        if (!mesh) throw null_argument("mesh");
        const auto known = find(mesh);
        return known ? ask(*known) : ask(MeshShape(mesh));
    }

  private:
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> shapes_;
    std::size_t size_max_ = 16;  // when that many are known, those that are gone are forgotten
};

}  // namespace ecods
