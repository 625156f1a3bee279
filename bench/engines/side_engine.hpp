// CGAL's answers about a point and a posed mesh, and about a mesh and itself.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/solid.hpp"

namespace ecods::bench {

// Side_of_triangle_mesh, of posed vertices, rounded. The mesh is an oriented manifold.
class SideOfMesh {
  public:
    SideOfMesh(const Mesh& mesh, const Pose& pose);  // with its tree
    ~SideOfMesh();

    Side side(const Vec3& point) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// A mesh made ready for Polygon_mesh_processing.
class ManifoldCgal {
  public:
    explicit ManifoldCgal(const Mesh& mesh);
    ~ManifoldCgal();

    bool does_self_intersect() const;  // does_self_intersect(), which finds contacts at points, too

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ecods::bench
