// OtherUnits scales bodies whose size is near the ends of the range of doubles.
//
// A result without a unit (a time, a name, an intersection) does not change if all bodies are scaled by 2^e. Without
// scaling, very small bodies are decided in integers, because bounds of rounding errors have terms for underflow; for
// bodies above a limit, doubles decide nothing. So bodies below 2^-200 or above 2^200 are scaled to about 1 for a
// query.
//
// A body is scaled by its pose. If the mesh's own coordinates are very small or large, a scaled mesh, which the shape
// caches, is used, too. Translations are always scaled. All scaling is exact; if it cannot be exact, the bodies are
// left as they are.
#pragma once

#include <array>
#include <initializer_list>
#include <span>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class OtherUnits {
  public:
    // Chooses units for two bodies at all the given poses, and for vectors by which they are moved, or the pivots of
    // their turns. Cost: some tens of nanoseconds.
    OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b);
    OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b, const Vec3& way_a, const Vec3& way_b);
    OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Vec3& motion = Vec3::Zero());
    OtherUnits(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b);
    OtherUnits(const Turning<MeshShape>& a, const Turning<MeshShape>& b);
    OtherUnits(const Turning<MeshShape>& a, const Moving<MeshShape>& b);
    // Chooses units for two bodies and any number of vectors in the world.
    OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, std::span<const Vec3> vectors);

    // Returns true if a query should use these units, each of which is 2^-e times a usual unit.
    bool are_better() const noexcept { return exponent_ != 0; }

    // Return the body, or the vector, in the chosen units. The first call for a shape may create a scaled shape, with
    // its tree.
    Posed<MeshShape> of(const Posed<MeshShape>& body) const;
    Moving<MeshShape> of(const Moving<MeshShape>& body) const;
    Turning<MeshShape> of(const Turning<MeshShape>& body) const;
    Vec3 of(const Vec3& motion) const noexcept;

  private:
    struct Body {
        const MeshShape* shape;
        std::array<const Pose*, 2> poses;
    };

    // Chooses units for bodies, and for vectors in the world.
    void choose(const std::array<Body, 2>& bodies, std::initializer_list<const Vec3*> vectors);
    bool can_scale(const Body& body) const;
    Pose pose_of(const MeshShape& shape, const Pose& pose) const;

    int exponent_ = 0;
};

}  // namespace ecods
