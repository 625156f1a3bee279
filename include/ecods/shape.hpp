// Shapes, which bodies are made of: triangle meshes, solids, convex solids, and shapes of the caller's own.
//
// Example: verify/examples/how_do_i, make_a_mesh().
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"

namespace ecods {

// The base of all shapes (FCL, Coal: CollisionGeometry). A shape is immutable while a body has it: a changed shape is a
// new one, given to the body by World::set_shape.
class ECODS_API Shape {
  public:
    virtual ~Shape() = default;

    virtual ShapeKind kind() const noexcept = 0;

    // Returns a box that contains every point of the shape at the pose. If a point lies outside, contacts may be lost.
    // The call that asked throws InvalidArgument if min > max or for a NaN.
    virtual Aabb box(const Pose& pose) const = 0;

    // Returns a hash of the shape's content, for World::digest. Equal shapes must give equal values.
    virtual std::uint64_t digest() const noexcept = 0;

    // Optional: the hits of a segment or ray with the shape. A shape that says Question::hits by answers() overrides
    // both forms of all_hits; the hits are ascending by parameter, then by triangle, and `rank` is not read. first_hit
    // is the first of them, which is what the default gives. Without, they throw NotSupported, and so does a World that
    // is asked for hits, before any body is asked.
    virtual bool answers(Question question) const noexcept;  // the default: none
    virtual std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const;
    virtual std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const;
    virtual std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const;
    virtual std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const;
};

// A triangle mesh with its tree of boxes (FCL, Coal: BVHModel; Parry: TriMesh). Trees and other data are made once,
// when a question first needs them, in any thread; bodies of one mesh should share one MeshShape.
// (World::create_body(mesh, pose) sees to that.) The body is the surface: the closed triangles.
//
// Cost: the box of a pose a constant, after about 0.1 microseconds a vertex the first time (of meshes beyond 2^900, or
// below 2^-900, a pass over the vertices); the tree about a microsecond a triangle (n log n), when a question first
// needs it. Casts of bodies beyond 2^200, or below 2^-200, make a mesh of moderate size, once, with its tree.
class ECODS_API MeshShape : public Shape {
  public:
    // Throws InvalidArgument for a null mesh.
    explicit MeshShape(std::shared_ptr<const Mesh> mesh);
    ~MeshShape() override;

    ShapeKind kind() const noexcept override { return ShapeKind::mesh(); }

    // Contains the exact body. Each side exceeds it by at most 1/8 of the mesh's half diagonal, and is within the box
    // of its oriented box; round meshes by less than 1.6 % of the radius. Tight to rounding for meshes of up to 32
    // vertices.
    Aabb box(const Pose& pose) const override;

    std::uint64_t digest() const noexcept override { return mesh_->digest(); }

    // These answer as hit.hpp says.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const override;

    const Mesh& mesh() const noexcept { return *mesh_; }
    const std::shared_ptr<const Mesh>& mesh_ptr() const noexcept { return mesh_; }

    // Returns the memory of the tree, beside vertices and triangles. Makes the tree if there is none yet.
    std::size_t tree_bytes() const;

  private:
    friend struct MeshShapeAccess;

    struct ECODS_HIDDEN Parts;
    std::shared_ptr<const Mesh> mesh_;
    std::unique_ptr<Parts> parts_;
};

// Returns the shape of a deforming mesh: the same triangles, other vertices. Reuses the structure of the tree of
// `shape` with new boxes; builds a new tree if the boxes' surfaces have grown to 1.5 times those at the last build.
// Give it to a body by World::set_shape. Answers are exact either way. Throws InvalidMesh, also if there are too few
// vertices. Cost: some passes over the triangles.
[[nodiscard]] ECODS_API std::shared_ptr<const MeshShape> refit(const MeshShape& shape, std::vector<Vec3> vertices);

// A mesh that bounds a solid. It is a MeshShape, so a World takes it for a body, and every question about two meshes
// takes it, of the surface; solid.hpp has the questions about the whole set.
//
// A mesh bounds a solid if its triangles of positive area (zero-area ones bound nothing and are left out)
//
//   - are closed: on every line, all but finitely many points lie on an even number of their edges. So a long edge may
//     face two halves, and an edge may be one of four triangles; and
//   - are free of self-intersection: no two of them share a segment or more, except along a side of both. Contacts at
//     isolated points (a vertex on a face, an edge across an edge) are harmless.
//
// Both are decided exactly for the mesh's own coordinates, corners at equal coordinates being one vertex (-0 is 0).
// The solid is the closure of the points of which a ray crosses the surface an odd number of times: how triangles are
// oriented does not matter, and cavities and several shells are allowed. A mesh of zero-area triangles alone bounds the
// empty set.
//
// Cost: that of check_solid at once; what solid_relation needs beside it, some passes over the triangles, when that is
// asked first. Memory: that of a MeshShape, and about 30 bytes a triangle. If corners are not named by one index each,
// or triangles have zero area, or a vertex lies inside an edge, there is a second mesh inside which is without these.
class ECODS_API Solid : public MeshShape {
  public:
    // Throws InvalidArgument for a null mesh, or NotSolid.
    explicit Solid(std::shared_ptr<const Mesh> mesh);
    ~Solid() override;

  private:
    friend struct SolidAccess;

    struct ECODS_HIDDEN Parts;
    std::unique_ptr<Parts> solid_parts_;
};

// Throws NotSolid unless the mesh bounds a solid; the error names an open edge or, if the mesh is closed, two triangles
// that intersect. The first of several defects is named: edges by triangle and corner, of pairs of triangles the
// least. Cost: about that of the mesh's tree, which it makes, and that of sorting vertices and edges; of a surface that
// is seen as a whole from the middle of its corners, as that of nearly every convex body is, no tree is made.
ECODS_API void check_solid(const Mesh& mesh);

// Returns every pair of triangles, the lesser index first, that share a segment or more which is not a side of both:
// pairs that cross, that have a side in the other's face, that overlap in one plane, folded over a common edge or one
// on the other. Ascending. The mesh need not be closed. Zero-area triangles are left out.
[[nodiscard]] ECODS_API std::vector<TrianglePair> self_intersections(const Mesh& mesh);

// A mesh that bounds a convex solid. It is a Solid, so every question about solids and meshes takes it.
//
// Cost: that of Solid, and an exact sign for each edge. Memory: that of a Solid, about 200 bytes a vertex of the set,
// and 4 bytes a vertex of the mesh.
class ECODS_API ConvexSolid final : public Solid {
  public:
    // Throws InvalidArgument for a null mesh, or NotSolid, which names a dent where the mesh has one.
    explicit ConvexSolid(std::shared_ptr<const Mesh> mesh);
    // Makes the convex hull of points. Throws as convex_hull() does.
    explicit ConvexSolid(std::span<const Vec3> points);
    ~ConvexSolid() override;

  private:
    friend struct ConvexSolidAccess;

    struct ECODS_HIDDEN ConvexParts;
    std::unique_ptr<ConvexParts> convex_parts_;
};

// Returns the convex hull of points. Its vertices are the points, in the order given, that are no convex combination of
// others, of equal ones the first; its triangles fan out from the least vertex of each face, turned outwards, ascending
// by their vertices. Exact: no point is outside. Throws InvalidMesh, which names the index of a point that is not
// finite, or too many points; NotSolid if all points lie in one plane, or there are none.
// Cost: n log n for most points; n f, of f faces, at worst.
[[nodiscard]] ECODS_API std::shared_ptr<const Mesh> convex_hull(std::span<const Vec3> points);

}  // namespace ecods
