// What is true of the bodies of a world, by the oracle. Bodies are named by their numbers (scenes/numbers_of.hpp), so
// that the truth of one world is that of all that were given the same calls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/world.hpp"
#include "oracle/distance.hpp"
#include "oracle/oracle.hpp"
#include "oracle/rounded.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {

// The mesh that a shape is, exactly. Null: the oracle knows nothing of this shape, and its body is left out.
using MeshOf = std::function<std::shared_ptr<const Mesh>(const Shape&)>;
std::shared_ptr<const Mesh> mesh_of_mesh_shape(const Shape& shape);

// The triangles on which the set of a shape ends: all, or of a solid those of positive area.
struct Boundary {
    std::shared_ptr<const Mesh> mesh;
    std::vector<std::uint32_t> names;  // by triangle: that of the shape's mesh; empty if they are the same
    bool has_inside = false;           // a solid, at a pose that is not singular

    std::uint32_t name(std::uint32_t triangle) const { return names.empty() ? triangle : names[triangle]; }
};
Boundary boundary_of(const Shape& shape, const std::shared_ptr<const Mesh>& mesh, const Pose& pose);

// The distance of two bodies, less their radii; of their sets, insides of solids included.
struct TrueBody;
oracle::RoundedDistance distance_of(const TrueBody& a, const TrueBody& b);

// The shape as its surface alone. It must be a MeshShape.
std::shared_ptr<const MeshShape> surface_shape(const std::shared_ptr<const Shape>& shape);

// A body, and a pair of bodies, as they are when the world is looked at.
struct TrueBody {
    BodyId id;
    std::shared_ptr<const Mesh> mesh;
    MeshForm form;    // a surface, too, if the shape is no MeshShape
    double radius;    // around all of this
    bool is_rounded;  // even if the radius is 0
    Pose pose;
    Boundary boundary;
    oracle::OracleMesh exact;  // of the boundary
    bool is_changed;           // since the last look

    oracle::Soup soup() const {
        return {.vertices = boundary.mesh->vertices(), .triangles = boundary.mesh->triangles(), .pose = pose};
    }
};
struct TruePair {
    BodyPair ids;
    oracle::Verdict verdict;        // of the boundaries; triangles are those of the shapes' meshes
    bool is_a_inside, is_b_inside;  // whether a part is inside the other body, if the boundaries share no point
    bool are_surfaces;              // both
    bool is_changed;                // one of the two is
    // If bodies have radii, `verdict` is of the rounded bodies, as far as they are apart, touch, or share inner points.
    std::optional<oracle::RoundedDistance> rounded = {};

    bool do_meet() const { return verdict.relation != Relation::apart || is_a_inside || is_b_inside; }
};

// True unless filters or the switch of the pair leave it out, by the words of the manual and not by the library.
inline bool may_meet(const World& world, BodyId a, BodyId b) {
    const CollisionFilter x = world.filter(a), y = world.filter(b);
    return (x.groups & y.mask) != 0 && (y.groups & x.mask) != 0 && world.is_pair_enabled(a, b);
}

// It is kept from frame to frame: only for pairs of which a body changed is the oracle asked, so that a world that lost
// a verdict that it kept is found, too.
class Truth {
  public:
    explicit Truth(MeshOf mesh_of = mesh_of_mesh_shape) : mesh_of_(std::move(mesh_of)) {}

    // Reads shapes and poses out of the world; its lists need not be up to date. Cost: each body that changed against
    // all boxes, and the oracle for those that overlap.
    void look_at(const World& world);

    std::span<const TrueBody> bodies() const noexcept { return bodies_; }  // ascending
    bool knows(BodyId body) const noexcept { return find(numbers_of(body)) != nullptr; }

    // True if the body's boundary has all triangles of its mesh.
    bool has_all_triangles(BodyId body) const noexcept { return find(numbers_of(body))->boundary.names.empty(); }

    // True if a body is rounded: nothing is decided yet of lines and motions.
    bool has_rounded() const noexcept { return std::ranges::any_of(bodies_, &TrueBody::is_rounded); }

    // Pairs whose certified boxes overlap, ascending; all others are apart.
    std::span<const TruePair> pairs() const noexcept { return pairs_; }

  private:
    const TrueBody* find(BodyId body) const noexcept;
    void renew_bodies(const World& world);
    void renew_pairs();

    MeshOf mesh_of_;
    std::vector<TrueBody> bodies_;
    std::vector<TruePair> pairs_;
};

}  // namespace ecods::fuzz
