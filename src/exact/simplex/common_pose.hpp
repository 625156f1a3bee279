// cancel_common_pose replaces the pose of all bodies by the identity, if all bodies have the same pose.
#pragma once

#include <span>

#include "base/assert.hpp"
#include "ecods/primitives.hpp"
#include "exact/point/frame.hpp"
#include "geometry/same_bits.hpp"

namespace ecods::exact {

// Returns true if the determinant of R is not zero. Exact: orient3d of the origin and the columns is the determinant's
// sign.
inline bool is_regular(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) != Sign::zero;
}

// Returns true if the determinant of R is negative: R maps a right-handed frame to a left-handed one. Exact.
inline bool is_mirror(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) == Sign::negative;
}

// Sets the poses of all bodies to the identity, if all poses have the same bits and their matrix is regular. A common
// affine bijection changes no relation between bodies, and the coordinates of meshes are often shorter before posing.
inline void cancel_common_pose(std::span<BodyRef> bodies) noexcept {
    static const Pose identity;
    ECODS_ASSERT(!bodies.empty());
    const Pose& first = *bodies[0].pose;
    for (const BodyRef& body : bodies) {
        if (!same_bits(*body.pose, first)) return;
    }
    if (!is_regular(first.R)) return;
    for (BodyRef& body : bodies) body.pose = &identity;
}

}  // namespace ecods::exact
