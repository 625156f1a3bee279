// PosedBody is the set of points that a posed mesh represents, with the data that queries about two bodies read.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns true if both bodies are surfaces, so that a question about them needs no code for solids.
inline bool are_surfaces(const MeshShape& a, const MeshShape& b) noexcept {
    return a.form() == MeshForm::surface && b.form() == MeshForm::surface;
}

// A NamedBoundary holds the triangles that bound the set: all triangles of a surface, or the triangles of positive area
// of a solid. `names` has, by triangle of `shape`, the triangle of the mesh; it is empty if both have the same
// triangles.
struct NamedBoundary {
    const MeshShape& shape;
    std::span<const std::uint32_t> names;
};
NamedBoundary boundary_of(const MeshShape& shape);
inline Posed<MeshShape> boundary_of(const Posed<MeshShape>& posed) {
    return {boundary_of(*posed.what).shape, posed.pose};
}

// A PosedBody is a posed shape as a set of points: a surface or a solid. The shape passed to the constructor must
// outlive it.
class PosedBody {
  public:
    // A Meaning selects the set of a shape: for Meaning::surface, a solid counts as its surface, with all triangles of
    // its mesh.
    enum class Meaning : std::uint8_t { set, surface };
    explicit PosedBody(const Posed<MeshShape>& posed, Meaning meaning = Meaning::set);

    const Posed<MeshShape>& boundary() const noexcept { return boundary_; }

    // Returns true if the set has inner points. A flat solid has none, and neither has a solid under a singular matrix.
    // The image of such a solid is the image of its surface, since on a line that is mapped to one point, an inner
    // point is between two points of the surface.
    bool has_inside() const noexcept { return solid_ != nullptr; }
    // Returns true for a convex solid at a regular pose, also for a flat one.
    bool is_convex() const noexcept { return convex_ != nullptr; }
    Posed<Solid> solid() const { return {*solid_, boundary_.pose}; }          // requires has_inside()
    Posed<ConvexSolid> convex() const { return {*convex_, boundary_.pose}; }  // requires is_convex()

    // Replaces a triangle of the boundary by the same triangle of the body's mesh. Keeps the order of triangles.
    void rename(std::uint32_t& triangle) const noexcept {
        if (!names_.empty()) triangle = names_[triangle];
    }
    void rename(Feature& feature) const noexcept {
        if (feature.kind != Feature::Kind::none) rename(feature.triangle);
    }

  private:
    Posed<MeshShape> boundary_;
    std::span<const std::uint32_t> names_;  // by triangle of the boundary; empty if it has the mesh's triangles
    const Solid* solid_ = nullptr;          // null if the set has no inner points
    const ConvexSolid* convex_ = nullptr;   // null unless the set is_convex()
};

// A BodyPairAsked holds the two bodies of a question.
struct BodyPairAsked {
    BodyPairAsked(const Posed<MeshShape>& first, const Posed<MeshShape>& second) : a(first), b(second) {}

    bool are_convex() const noexcept { return a.is_convex() && b.is_convex(); }

    // Replaces the triangles that `answer.a` and `answer.b` name in the boundaries by the same triangles of the bodies'
    // meshes.
    template <class Answer>
    void rename(Answer& answer) const noexcept {
        a.rename(answer.a);
        b.rename(answer.b);
    }

    PosedBody a, b;
};

}  // namespace ecods
