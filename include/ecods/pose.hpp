// Where a body is.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

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

    // q is taken as given, not normalised: R is what Eigen's toRotationMatrix() computes from it, sums and products of
    // its coefficients, each rounded. That R is then the pose, as for any other R: not exactly orthogonal in general.
    static Pose from_quaternion(const Eigen::Quaterniond& q, const Vec3& t) {
        return from_quaternion(q.w(), q.x(), q.y(), q.z(), t);
    }
    static Pose from_isometry(const Eigen::Isometry3d& m) { return {m.linear(), m.translation()}; }

    // Throws InvalidArgument unless the last row is 0 0 0 1. Nothing is rounded.
    static Pose from_matrix(const Eigen::Matrix4d& m) {
        require_last_row(m(3, 0), m(3, 1), m(3, 2), m(3, 3));
        return {m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
    }

    friend bool operator==(const Pose& a, const Pose& b) { return a.R == b.R && a.t == b.t; }

  private:
    // Numbers, not Eigen's types of 32 bytes and more: how those are aligned depends on how the caller is compiled.
    ECODS_API static Pose from_quaternion(double w, double x, double y, double z, const Vec3& t);
    ECODS_API static void require_last_row(double x, double y, double z, double w);
};

// Library and caller must agree on the layout whatever instruction set each is compiled for.
static_assert(alignof(Pose) == alignof(double) && sizeof(Pose) == 12 * sizeof(double));

// Throws InvalidArgument for the first entry, row by row of [R t], that is NaN or infinite.
ECODS_API void validate(const Pose& pose);

}  // namespace ecods
