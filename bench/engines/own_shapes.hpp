// The meshes of a workload as ECoDS has them, for questions about two bodies.
#pragma once

#include <memory>
#include <vector>

#include "ecods/pose.hpp"
#include "scenes/mesh_pairs.hpp"

namespace ecods::bench {

template <class Shape>
class OwnShapes {
  public:
    explicit OwnShapes(const std::vector<scenes::NamedMesh>& meshes) {
        for (const scenes::NamedMesh& named : meshes) {
            shapes_.push_back(std::make_unique<Shape>(named.mesh));
            shapes_.back()->tree_bytes();  // makes the tree
        }
    }

    const Shape& at(std::size_t mesh_index) const { return *shapes_[mesh_index]; }
    Posed<Shape> operator()(const scenes::MeshAt& body) const { return {at(body.mesh_index), body.pose}; }

  private:
    std::vector<std::unique_ptr<Shape>> shapes_;
};

}  // namespace ecods::bench
