// Where a body is.
#pragma once

#include <Eigen/Core>

#include <cstdint>

#include "ecods/export.hpp"

namespace ecods {

// Points, differences and sizes, in the unit that the caller chose for lengths. No unit is preferred: an answer
// for coordinates times a power of two is the same answer.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

// The map v -> R v + t. A body is the set of the real points R v + t for the points v of its mesh, nothing
// rounded. Any finite R is allowed: it may scale, shear, mirror or be singular, and the image is what counts.
// A rotation written in doubles is in general not exactly orthogonal; the pose is taken as it is written.
struct Pose {
    Mat3 R = Mat3::Identity();
    Vec3 t = Vec3::Zero();

    friend bool operator==(const Pose& a, const Pose& b) { return a.R == b.R && a.t == b.t; }
};

// Library and caller must agree on the layout whatever instruction set each is compiled for.
static_assert(alignof(Pose) == alignof(double) && sizeof(Pose) == 12 * sizeof(double));

// Throws InvalidPose for the first entry, row by row of [R t], that is NaN or infinite.
ECODS_API void validate(const Pose& pose);

}  // namespace ecods
