// The set of points that a posed mesh is, as the questions about two bodies see it.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// True if both bodies are surfaces: questions about them need not know of solids.
inline bool are_surfaces(const MeshShape& a, const MeshShape& b) noexcept {
    return a.form() == MeshForm::surface && b.form() == MeshForm::surface;
}

// The triangles on which the set ends: all of a surface, those of positive area of a solid. `names` are those of the
// mesh, by triangle; empty if they are the same.
struct NamedBoundary {
    const MeshShape& shape;
    std::span<const std::uint32_t> names;
};
NamedBoundary boundary_of(const MeshShape& shape);
inline Posed<MeshShape> boundary_of(const Posed<MeshShape>& posed) {
    return {boundary_of(*posed.what).shape, posed.pose};
}

// A posed shape as a set of points: a surface or a solid. The shape passed to the constructor must outlive it.
class PosedBody {
  public:
    // A solid may be taken for its surface, with all triangles of its mesh.
    enum class Meaning : std::uint8_t { set, surface };
    explicit PosedBody(const Posed<MeshShape>& posed, Meaning meaning = Meaning::set);

    const Posed<MeshShape>& boundary() const noexcept { return boundary_; }

    // True if the set has inner points. A flat solid has none. The image of a solid under a singular matrix has none:
    // it is the image of its surface, since on a line that is mapped to one point, an inner point is between two points
    // of the surface.
    bool has_inside() const noexcept { return solid_ != nullptr; }
    // True for a convex solid, a flat one too, at a regular pose.
    bool is_convex() const noexcept { return convex_ != nullptr; }
    Posed<Solid> solid() const { return {*solid_, boundary_.pose}; }          // requires has_inside()
    Posed<ConvexSolid> convex() const { return {*convex_, boundary_.pose}; }  // requires is_convex()

    // Renames a triangle of the boundary to that of the body's mesh. Keeps the order of triangles.
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
    const ConvexSolid* convex_ = nullptr;   // null if the set is not is_convex()
};

// Two bodies of a question.
struct BodyPairAsked {
    BodyPairAsked(const Posed<MeshShape>& first, const Posed<MeshShape>& second) : a(first), b(second) {}

    bool are_convex() const noexcept { return a.is_convex() && b.is_convex(); }

    // Renames the triangles of an answer, which has members `a` and `b`.
    template <class Answer>
    void rename(Answer& answer) const noexcept {
        a.rename(answer.a);
        b.rename(answer.b);
    }

    PosedBody a, b;
};

}  // namespace ecods
