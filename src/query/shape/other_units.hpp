// Bodies near the ends of the range of doubles, in other units.
//
// An answer that has no unit (a time, a name, whether two bodies meet) is that of bodies which are 2^e times as large.
// Bounds of rounding errors have terms for underflow, below which nothing is decided without integers, and limits,
// above which nothing is: so bodies below 2^-200 or above 2^200 are asked for as large as 1.
//
// A body is made larger by its pose, and where its vertices are small or large themselves by a mesh of its own, which
// its shape keeps. Translations are made larger either way. Everything is exact, or the bodies stay as they are.
#pragma once

#include <array>

#include "ecods/motion.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class OtherUnits {
  public:
    // For all poses of two bodies, and a vector by which one of them is moved. Cost: some dozens of nanoseconds.
    OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b);
    OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Vec3& motion = Vec3::Zero());

    // True if bodies should be asked about in these units, which are 2^-e times the usual ones.
    bool are_better() const noexcept { return exponent_ != 0; }

    // Both bodies, or the vector, in these units. The first call for a shape may make another one, with its tree.
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
