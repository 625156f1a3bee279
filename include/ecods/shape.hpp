// What the bodies of a World can be: triangle meshes, and shapes of the caller's own.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/aabb.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"

namespace ecods {

// The base of all shapes. A shape is immutable while a body has it: a changed shape is a new one, given to the
// body by World::set_shape.
class Shape {
  public:
    virtual ~Shape() = default;

    virtual ShapeKind kind() const noexcept = 0;

    // A box that contains every point of the shape at the pose. The broad phase trusts it: a point outside may be a
    // contact lost. min <= max and no NaN, else InvalidBox at the call that asked.
    virtual Aabb box(const Pose& pose) const = 0;

    // A hash of what the shape is, for World::digest. Equal shapes must give equal values.
    virtual std::uint64_t digest() const noexcept = 0;
};

// A triangle mesh with its box tree. The tree is built when the first query needs it, once, whichever thread
// asks; bodies of one mesh should share one MeshShape. (World::create_body(mesh, pose) sees to that.)
class MeshShape final : public Shape {
  public:
    // Throws NullArgument.
    explicit MeshShape(std::shared_ptr<const Mesh> mesh);
    ~MeshShape() override;

    ShapeKind kind() const noexcept override { return ShapeKind::mesh(); }
    Aabb box(const Pose& pose) const override;
    std::uint64_t digest() const noexcept override { return mesh_->digest(); }

    const Mesh& mesh() const noexcept { return *mesh_; }
    const std::shared_ptr<const Mesh>& mesh_ptr() const noexcept { return mesh_; }

    struct Tree;  // of the implementation
    const Tree& tree() const;

  private:
    struct LazyTree;
    std::shared_ptr<const Mesh> mesh_;
    std::unique_ptr<LazyTree> lazy_;
};

// A shape at a pose. Both are referred to, not copied.
struct PosedShape {
    const Shape& shape;
    const Pose& pose;
};

class QueryMemory;

// The test of two bodies, for one pair of kinds. A World calls it for candidate pairs only, with the shape of the first
// kind first. It must be a function of its arguments: verdicts are kept while neither body changes.
class TwoBodyTest {
  public:
    virtual ~TwoBodyTest() = default;

    // Whether the shapes share a point.
    virtual bool intersects(const PosedShape& a, const PosedShape& b, QueryMemory& memory) const = 0;

    // Disjoint, touching or crossing; disjoint exactly when intersects() is false.
    virtual Relation relation(const PosedShape& a, const PosedShape& b, QueryMemory& memory) const = 0;

    // Optional: the pairs of triangles that touch, ascending. The default throws NotSupported.
    virtual std::vector<TrianglePair> touching_triangles(const PosedShape& a, const PosedShape& b,
                                                         QueryMemory& memory) const;
};

}  // namespace ecods
