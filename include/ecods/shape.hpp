// What the bodies of a World can be: triangle meshes, and shapes of the caller's own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/aabb.hpp"
#include "ecods/closest_points.hpp"
#include "ecods/export.hpp"
#include "ecods/first_contact.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/motion.hpp"
#include "ecods/pose.hpp"
#include "ecods/posed.hpp"
#include "ecods/predicates.hpp"
#include "ecods/segment.hpp"
#include "ecods/shared_set.hpp"
#include "ecods/triangle_hit.hpp"

namespace ecods {

class QueryMemory;

// The base of all shapes. A shape is immutable while a body has it: a changed shape is a new one, given to the
// body by World::set_shape.
class ECODS_API Shape {
  public:
    virtual ~Shape() = default;

    virtual ShapeKind kind() const noexcept = 0;

    // A box that contains every point of the shape at the pose. The broad phase trusts it: a point outside may be a
    // contact lost. min <= max and no NaN, otherwise InvalidArgument at the call that asked.
    virtual Aabb box(const Pose& pose) const = 0;

    // A hash of what the shape is, for World::digest. Equal shapes must give equal values.
    virtual std::uint64_t digest() const noexcept = 0;

    // Optional: what a segment or a ray meets of the shape. A shape that says Question::hits by answers() overrides
    // both forms of all_hits; the hits are ascending by parameter, then by triangle, and `rank` is not read. first_hit
    // is the first of them, which is what the default gives. Without, they throw NotSupported, and so does a World that
    // is asked for hits, before any body is asked.
    virtual bool answers(Question question) const noexcept;  // the default: none
    virtual std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, QueryMemory& memory) const;
    virtual std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, QueryMemory& memory) const;
    virtual std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, QueryMemory& memory) const;
    virtual std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, QueryMemory& memory) const;
};

// A triangle mesh with its box tree. What queries need of a mesh is made when the first of them asks, once, whichever
// thread that is in; bodies of one mesh should share one MeshShape. (World::create_body(mesh, pose) sees to that.)
//
// Cost: the box of a pose a constant, after about 0.1 microseconds a vertex the first time (of meshes beyond 2^900, or
// below 2^-900, a pass over the vertices); the tree about a microsecond a triangle (n log n), when a query first needs
// it. Casts of bodies beyond 2^200, or below 2^-200, make a mesh of moderate size of their meshes, once, with its tree.
class ECODS_API MeshShape : public Shape {
  public:
    // Throws InvalidArgument.
    explicit MeshShape(std::shared_ptr<const Mesh> mesh);
    ~MeshShape() override;

    ShapeKind kind() const noexcept override { return ShapeKind::mesh(); }

    // Contains the exact body. On no side further out than an eighth of the mesh's half diagonal, nor than the box of
    // its oriented box; for round meshes below 1.6 % of the radius. Tight to rounding for meshes of up to 32 vertices.
    Aabb box(const Pose& pose) const override;

    std::uint64_t digest() const noexcept override { return mesh_->digest(); }

    // As in hit.hpp.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, QueryMemory& memory) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, QueryMemory& memory) const override;
    std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, QueryMemory& memory) const override;
    std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, QueryMemory& memory) const override;

    const Mesh& mesh() const noexcept { return *mesh_; }
    const std::shared_ptr<const Mesh>& mesh_ptr() const noexcept { return mesh_; }

    // Memory of the tree, beside vertices and triangles. Makes the tree if there is none yet.
    std::size_t tree_bytes() const;

  private:
    friend struct MeshShapeAccess;

    struct ECODS_HIDDEN Parts;
    std::shared_ptr<const Mesh> mesh_;
    std::unique_ptr<Parts> parts_;
};

// The shape of a deforming mesh: the same triangles, other vertices. Its tree has the structure of that of `shape`,
// with new boxes, unless it has grown bad (its surfaces half as much again as when it was built): then it is built
// from scratch. Give it to a body by World::set_shape. Answers are exact either way. Throws InvalidMesh, also
// if there are too few vertices. Cost: some passes over the triangles.
ECODS_API std::shared_ptr<const MeshShape> refit(const MeshShape& shape, std::vector<Vec3> vertices);

// What decided a pair of bodies the last time, for the test that left it: of meshes, the triangles that touched, or the
// axis that separated them. It is only ever tried first, and tried exactly: whatever it holds, from whichever bodies,
// no answer depends on it. A new one knows nothing.
struct PairWitness {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t a = none;
    std::uint32_t b = none;
};

// The test of two bodies, for one pair of kinds. A World calls it for candidate pairs only, with the shape of the first
// kind first. It must be a function of its arguments: verdicts are kept while neither body changes.
class ECODS_API TwoBodyTest {
  public:
    virtual ~TwoBodyTest() = default;

    // Whether the shapes share a point.
    virtual bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const = 0;

    // Optional: the same for a pair that was tested before and has moved little, as bodies of a World do; `witness` is
    // what the last call left. It must not change the answer. The default does not use it.
    virtual bool intersects_again(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory,
                                  PairWitness& witness) const;

    // Optional questions: a test overrides those that it answers, and says so by answers(). The others throw
    // NotSupported, with the kinds and the question, and so does World where it is asked one of them. Where World asks
    // of many pairs (set_clearance, nearest, closest_pair, cast, meetings), a test that does not answer is refused
    // before any is asked.
    virtual bool answers(Question question) const noexcept;  // the default: none of them

    // Disjoint, touching or crossing; disjoint exactly when intersects() is false.
    virtual Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const;

    // The pairs of triangles that share a point, ascending.
    virtual std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                             QueryMemory& memory) const;

    // The distance, rounded once; 0 exactly when intersects() is true.
    virtual double distance(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const;

    // Whether the distance is at most d >= 0, decided for the real number, and true wherever intersects() is. Optional
    // beside it: the same with a witness, as intersects_again() is.
    virtual bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, QueryMemory& memory) const;
    virtual bool within_again(const Posed<Shape>& a, const Posed<Shape>& b, double d, QueryMemory& memory,
                              PairWitness& witness) const;

    // The closest points.
    virtual ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const;

    // As in contact.hpp.
    virtual std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                            QueryMemory& memory) const;
    virtual std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double d,
                                                      QueryMemory& memory) const;

    // The first contact of a, which is translated by time times `motion`, with b, and that of two shapes of which each
    // goes from one pose to another (cast.hpp); nothing if there is none up to `time_max`, from 0 to 1, decided for the
    // real time. The time is 0 exactly when intersects() is true at the start. Where the shape that a World moves is of
    // the second kind, the other one is moved here by -motion.
    virtual std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b,
                                             double time_max, QueryMemory& memory) const;
    virtual std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double time_max,
                                                    QueryMemory& memory) const;
};

}  // namespace ecods
