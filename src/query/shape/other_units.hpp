// Scales bodies near the ends of the range of doubles to other units.
//
// An answer without a unit (a time, a name, an intersection) is the same for bodies that are 2^e times as large. Bounds
// of rounding errors have terms for underflow, which leave very small bodies to integers, and limits above which they
// decide nothing. So queries about bodies below 2^-200 or above 2^200 are answered for bodies scaled to about 1.
//
// The pose scales a body. If the vertices themselves are very small or large, a scaled mesh does so, which the shape
// keeps. Translations are scaled either way. All scaling is exact; otherwise the bodies stay as they are.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class OtherUnits {
  public:
    // Chooses units for all poses of two bodies, and for a vector by which one of them is moved. Cost: some dozens of
    // nanoseconds.
    OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b);
    OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Vec3& motion = Vec3::Zero());

    // True if queries should use these units, which are 2^-e times the usual ones.
    bool are_better() const noexcept { return exponent_ != 0; }

    // The body, or the vector, in these units. The first call for a shape may make another shape, with its tree.
    Posed<MeshShape> of(const Posed<MeshShape>& body) const;
    Moving<MeshShape> of(const Moving<MeshShape>& body) const;
    Vec3 of(const Vec3& motion) const noexcept;

  private:
    struct Body {
        const MeshShape* shape;
        std::array<const Pose*, 2> poses;
    };

    void choose(const std::array<Body, 2>& bodies, const Vec3& motion);
    bool can_scale(const Body& body) const;
    Pose pose_of(const MeshShape& shape, const Pose& pose) const;

    int exponent_ = 0;
};

}  // namespace ecods
