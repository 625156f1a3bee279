// cancel_common_pose replaces a pose that all bodies have in common by the identity.
#pragma once

#include <span>

#include "base/assert.hpp"
#include "ecods/predicates.hpp"
#include "exact/point/frame.hpp"
#include "geometry/same_bits.hpp"

namespace ecods::exact {

// True if a matrix is a bijection. Exact: orient3d of the origin and the columns has the determinant's sign.
inline bool is_regular(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) != Sign::zero;
}

// True if a matrix turns a right-handed frame into a left-handed one. Exact, too.
inline bool is_mirror(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) == Sign::negative;
}

// Gives all bodies the identity for a pose if their poses have the same bits and are regular. A common affine bijection
// changes no relation between the bodies, and coordinates are shorter where the bodies were modelled.
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
