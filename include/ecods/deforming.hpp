// A Deforming mesh has other vertices at time 1 than at time 0: cloth, skin, soft bodies, the steps of a simulation.
// Casts of it find when it first shares a point with another body. (Continuous collision detection of vertices and
// faces, edges and edges: Provot 1997; Brochu, Edwards and Bridson 2012.) No World is needed.
//
//     const Deforming cloth(shape, vertices_at_the_end);
//     if (auto contact = cast(cloth, {floor, Pose()})) contact->time, contact->a, contact->b
//
// At a time s from 0 to 1, each vertex is at the real point (1 - s) v0 + s v1, in the coordinates of the world, and
// each triangle is the one that its vertices then span: so the mesh may stretch, fold, become flat or turn inside out.
// The mesh is a surface, also if its shape is a solid; a body that it is inside of, or that is inside of it, is met as
// intersects() says of a surface. All else is as in cast.hpp: contact at time 0 and at the last time counts, and so
// does grazing; the time is the least real time, rounded once; everything is defined for zero-area triangles and for
// meshes that become flat; and equal input gives equal bits. A vertex alone is a triangle {i, i, i} and an edge alone a
// triangle {i, j, j}.
//
// Contacts of a mesh with itself are not found, nor is there a cast of a deforming mesh with a body that turns, with a
// rounded body or with a half space. World::cast() takes a deforming mesh against the bodies of a World, at rest.
//
// Example: verify/examples/how_do_i, cast_a_cloth().
// Example: verify/examples/how_do_i, cast_a_cloth_in_a_world().
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// A Deforming is immutable. Copies share their data, and several threads may ask about one at the same time.
class ECODS_API Deforming {
  public:
    // Takes the mesh of the shape at time 0, and the place of each of its vertices at time 1. For a step that goes on
    // from this one, pass refit(shape, vertices) as the shape. Throws InvalidArgument for a null shape; InvalidMesh for
    // a coordinate that is not finite, and if there are too few vertices; further vertices are ignored. Cost: the tree
    // of the shape if it has none yet, and some passes over the triangles.
    Deforming(std::shared_ptr<const MeshShape> shape, std::vector<Vec3> vertices_at_end);

    const std::shared_ptr<const MeshShape>& shape() const noexcept;  // at time 0
    const Mesh& mesh_at_end() const noexcept;                        // at time 1
    const Aabb& box() const noexcept;  // the least box that contains all triangles at all times

  private:
    friend struct DeformingAccess;
    struct ECODS_HIDDEN Parts;
    std::shared_ptr<const Parts> parts_;
};

// Return the first contact of a deforming mesh with a body at rest, a body that moves from one pose to another
// (cast.hpp), or another deforming mesh, in either order; nullopt if there is none up to max_time. If a part of one
// body is inside a solid at the start, the first contact is at time 0. Start from a witness, and leave the triangles
// that decided. Throw InvalidArgument if max_time is negative or NaN; a max_time above 1 counts as 1.
//
// Cost: that of cast() of moving bodies, as long as triangles that are near each other at time 0 stay near each other:
// the tree of boxes is that of time 0, with boxes at both ends of the motion. Meshes above 2^200 or below 2^-200 cost
// much more.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Posed<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Deforming& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Deforming& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Deforming& b, double max_time = 1,
                                                         const Ask& ask = {});

}  // namespace ecods
