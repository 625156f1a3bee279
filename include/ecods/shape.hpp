// Shapes are what bodies are made of: triangle meshes, solids, convex solids, rounded shapes (rounded.hpp), half spaces
// (solid.hpp), and shapes of the caller's own.
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

// A Shape is the base class of all shapes (FCL, Coal: CollisionGeometry). It must not change while a body has it. To
// change a body's shape, give it a new one by World::set_shape.
class ECODS_API Shape {
  public:
    virtual ~Shape() = default;

    virtual ShapeKind kind() const noexcept = 0;

    // Returns a box that contains every point of the shape at the pose. If a point is outside the box, contacts may be
    // lost. If min > max or a number is NaN, the call of the library that uses the box throws InvalidArgument.
    virtual Aabb box(const Pose& pose) const = 0;

    // Returns a hash of the shape's content, for World::digest. Equal shapes must return equal hashes.
    virtual std::uint64_t digest() const noexcept = 0;

    // Hits of a segment or ray are optional. A shape for which answers(Question::hits) is true overrides both forms of
    // all_hits, which return hits ascending by parameter; a World keeps the order of hits with the same parameter (a
    // mesh orders them by triangle), and ignores `rank`. first_hit returns the first hit; by default it calls all_hits.
    // For shapes that do not answer hits, all four throw NotSupported; a World that is asked for hits then throws it
    // before it asks any body.
    virtual bool answers(Question question) const noexcept;  // by default: none
    virtual std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const;
    virtual std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const;
    virtual std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const;
    virtual std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const;
};

// A MeshForm says what a mesh's shape stands for: its surface, which is the closed triangles; the solid that they
// bound; or a convex solid.
enum class MeshForm : std::uint8_t { surface, solid, convex };

// A MeshShape is a triangle mesh with its tree of boxes (FCL, Coal: BVHModel; Parry: TriMesh). The body is the surface:
// the closed triangles. The tree and other data are made once, when a question first needs them, in any thread. So
// bodies with the same mesh should share one MeshShape; World::create_body(mesh, pose) does that.
//
// Cost: box() is constant, after about 0.1 microseconds a vertex the first time (for meshes with coordinates beyond
// 2^900 or below 2^-900, it is a pass over the vertices); the tree takes about a microsecond a triangle (n log n).
// Casts of bodies with coordinates beyond 2^200 or below 2^-200 make a scaled copy of the mesh, once, with its tree.
class ECODS_API MeshShape : public Shape {
  public:
    // Throws InvalidArgument for a null mesh.
    explicit MeshShape(std::shared_ptr<const Mesh> mesh);
    ~MeshShape() override;

    ShapeKind kind() const noexcept override { return ShapeKind::mesh(); }
    MeshForm form() const noexcept { return form_; }

    // Returns a box that contains the exact body. Each side exceeds the body by at most 1/8 of the mesh's half diagonal
    // (for round meshes, by less than 1.6 % of the radius), and is within the box of the mesh's oriented box. Up to 32
    // vertices, the box is tight up to rounding.
    Aabb box(const Pose& pose) const override;

    std::uint64_t digest() const noexcept override { return mesh_->digest(); }

    // Answer questions about hits as hit.hpp says.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const override;

    const Mesh& mesh() const noexcept { return *mesh_; }
    const std::shared_ptr<const Mesh>& mesh_ptr() const noexcept { return mesh_; }

    // Returns the memory of the tree, without vertices and triangles. Makes the tree if there is none yet.
    std::size_t tree_bytes() const;

  private:
    friend struct MeshShapeAccess;
    friend class Solid;

    struct ECODS_HIDDEN Parts;
    ECODS_HIDDEN MeshShape(std::shared_ptr<const Mesh> mesh, MeshForm form);
    ECODS_HIDDEN MeshShape(std::shared_ptr<const Mesh> mesh, std::shared_ptr<Parts> parts);

    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<Parts> parts_;  // shared by a solid and its surface
    MeshForm form_ = MeshForm::surface;
};

// Returns a shape with the same triangles and other vertices, for a mesh that deforms; give it to a body by
// World::set_shape. The new shape has the tree of `shape` with new boxes. If the surface areas of the boxes have grown
// to 1.5 times those at the last build, a new tree is built instead. Answers are exact either way. Throws InvalidMesh,
// also if there are too few vertices. Cost: some passes over the triangles.
[[nodiscard]] ECODS_API std::shared_ptr<const MeshShape> refit(const MeshShape& shape, std::vector<Vec3> vertices);

// A Solid is a mesh that bounds a solid: the closed set of the points inside and on the surface. (The boxes and convex
// shapes of FCL, Coal, Bullet and Jolt are such sets.) Every question, and a World, takes the whole set, so a body
// inside a solid meets it, at distance 0. surface_of(solid) is the surface alone.
//
// A mesh bounds a solid if its triangles of positive area (zero-area ones bound nothing and are left out)
//
//  - are closed: on every line, all but finitely many points lie on an even number of their edges. So a long edge may
//    face two halves, and an edge may be one of four triangles; and
//  - are free of self-intersection: no two of them share a segment or more, except along a side of both. Contacts at
//    isolated points (a vertex on a face, an edge across an edge) are harmless.
//
// Both conditions are decided exactly for the mesh's own coordinates. Corners with equal coordinates are one vertex (-0
// equals 0). The solid is the closure of the points from which a ray crosses the surface an odd number of times. So the
// orientation of triangles does not matter, and cavities and several shells are allowed. If all triangles have zero
// area, the mesh bounds nothing, and is no solid.
//
// Cost: that of check_solid at once; some passes over the triangles at the first relation(). Memory: that of a
// MeshShape, and about 30 bytes a triangle. If corners with equal coordinates have different indices, triangles have
// zero area, or a vertex lies inside an edge, a second mesh without these is stored inside.
class ECODS_API Solid : public MeshShape {
  public:
    // Throws InvalidArgument for a null mesh, or NotSolid.
    explicit Solid(std::shared_ptr<const Mesh> mesh);
    ~Solid() override;

  private:
    friend struct SolidAccess;
    friend class ConvexSolid;

    ECODS_HIDDEN Solid(std::shared_ptr<const Mesh> mesh, MeshForm form);

    struct ECODS_HIDDEN Parts;
    std::unique_ptr<Parts> solid_parts_;
};

// Returns the surface of the solid as a shape of its own: all triangles of its mesh. The surface shares the solid's
// mesh and tree, and is the same object each time.
[[nodiscard]] ECODS_API std::shared_ptr<const MeshShape> surface_of(const Solid& solid);

// Throws NotSolid unless the mesh bounds a solid. The error names an open edge or, if the mesh is closed, two triangles
// that intersect. If there are several defects, it names the first: edges by triangle and corner, or the least pair of
// triangles. Cost: about that of building the mesh's tree, and of sorting vertices and edges. No tree is built if all
// of the surface is visible from the mean of its corners, as it is for nearly every convex body.
ECODS_API void check_solid(const Mesh& mesh);

// Returns every pair of triangles that share a segment or more which is not a side of both, ascending, with the lesser
// index first. Such triangles cross, or a side of one is in the other's face, or they overlap in one plane: folded over
// a common edge, or one on the other. The mesh need not be closed. Zero-area triangles are left out.
[[nodiscard]] ECODS_API std::vector<TrianglePair> self_intersections(const Mesh& mesh);

// A ConvexSolid is a mesh that bounds a convex solid, or covers a flat one: a convex polygon, a segment or a point. The
// distance of two convex solids is found by a search of its own, faster than the search of triangles; and two of them
// have a depth (solid.hpp).
//
// A mesh covers a convex polygon if its triangles of positive area, in any orientation, tile it edge to edge: each of
// their sides is a side of exactly one other triangle, or lies on the border. Triangles of zero area are left out. A
// mesh without a triangle of positive area covers a segment, if its triangles are pieces of the segment that leave no
// gap, or a point. Both cases are decided exactly; other meshes in one plane are no convex solids.
//
// A flat solid has no inner points. In every question it is the closed set: a body inside it shares points with it. Its
// relation to a solid is that of a surface: inside, touching, also in a face, or crossing, and never overlapping. Its
// relation to another flat solid or to a surface is that of two triangles, as if the polygon was one triangle; at a
// singular pose, it is that of its triangles.
//
// Cost: that of Solid, and an exact sign for each edge. Memory: that of a Solid, about 200 bytes for each vertex of the
// set, and 4 bytes for each vertex of the mesh.
class ECODS_API ConvexSolid final : public Solid {
  public:
    // Throws InvalidArgument if the mesh is null. Throws NotSolid if the mesh covers no flat convex set and either
    // bounds no solid (no_interior, open_edge or self_intersection, as Solid does) or bounds a solid that is not convex
    // (dent).
    explicit ConvexSolid(std::shared_ptr<const Mesh> mesh);
    // Makes the convex hull of the points. Throws the errors of convex_hull().
    explicit ConvexSolid(std::span<const Vec3> points);
    ~ConvexSolid() override;

    // Returns the dimension of the solid: 3 if it has inner points, 2 if it is a polygon, 1 if it is a segment and 0 if
    // it is a point.
    int dimension() const noexcept;

  private:
    friend struct ConvexSolidAccess;

    struct ECODS_HIDDEN ConvexParts;
    std::unique_ptr<ConvexParts> convex_parts_;
};

// Returns the convex hull of the points. Its vertices are the points that are no convex combination of others, in the
// order given; of equal points, the first. The triangles of each face form a fan from its least vertex. They face
// outwards, and are sorted by their vertices. The hull is exact: no point is outside. If all points lie in one plane,
// the hull is a polygon, whose normal's first coordinate that is not zero is positive; or a segment, the triangle {0,
// 1, 1}; or a point, {0, 0, 0}. Throws InvalidMesh, which names the index of a point that is not finite, or says that
// there are too many points; NotSolid if there are no points. Cost: n log n for most points; n f, for f faces, at
// worst.
[[nodiscard]] ECODS_API std::shared_ptr<const Mesh> convex_hull(std::span<const Vec3> points);

// ---- two-body tests of the caller's own

// A two-body test answers questions about the caller's own shapes (World::set_test). (FCL, Coal:
// CollisionFunctionMatrix; Parry: QueryDispatcher; Bullet: btCollisionAlgorithm.)
//
// Example: verify/examples/own_shape.

// A TwoBodyTest answers questions about two shapes of one pair of kinds. A World calls a test only for candidate pairs,
// with the shape of the first kind first. Answers must depend on the shapes and poses alone: a verdict is kept while
// neither body changes. In `ask` a World always gives a memory, and the witness that the last call for the pair left,
// if it stores one; no answer may depend on memory or witness. A test that asks a World a question must pass this
// memory on: without a memory, the executor runs the question after the call that runs the test, so the test would wait
// for ever.
class ECODS_API TwoBodyTest {
  public:
    virtual ~TwoBodyTest() = default;

    // Returns true if the shapes share a point.
    virtual bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const = 0;

    // The following questions are optional: a test overrides those that it answers, and answers() returns true for
    // them. The others throw NotSupported, with the kinds and the question; a World that is asked one of them throws
    // it, too. If a World asks about many pairs (set_clearance, nearest, closest_pair, cast, meetings), it refuses a
    // test that does not answer before it asks any.
    virtual bool answers(Question question) const noexcept;  // by default: none

    // Returns the relation of a to b: apart exactly if intersects() is false.
    virtual Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns the pairs of triangles that share a point, ascending.
    virtual std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                             const Ask& ask) const;

    // Returns the distance, rounded once; 0 exactly if intersects() is true.
    virtual double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns true if the real distance is at most max_distance >= 0, so always if intersects() is true.
    virtual bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const;

    virtual ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Answer the questions of the same names in intersection.hpp and distance.hpp, in the same way.
    virtual std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                            const Ask& ask) const;
    virtual std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance,
                                                      const Ask& ask) const;

    // Return the first contact of a, translated by time times `motion`, with b; or of two shapes that each move from
    // one pose to another (cast.hpp). Return nullopt if the real time is above max_time, which is from 0 to 1. The time
    // is 0 exactly if intersects() is true at the start. If the shape that a World moves is of the second kind, `a` is
    // the other shape, moved by -motion.
    virtual std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b,
                                             double max_time, const Ask& ask) const;
    virtual std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                                    const Ask& ask) const;

    // Returns the first contact of two shapes that move in any way (turn.hpp), with max_time and times as above. A
    // World asks this if one turns, or is translated among bodies that move (meetings); a body at rest has the motion
    // Motion().
    virtual std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a,
                                                        const Posed<Shape>& b, const Motion& motion_of_b,
                                                        double max_time, const Ask& ask) const;
};

}  // namespace ecods
