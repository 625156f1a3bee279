// Bodies that have one pose in common.
#pragma once

#include <span>

#include "base/assert.hpp"
#include "ecods/predicates.hpp"
#include "exact/point/frame.hpp"
#include "geometry/same_bits.hpp"

namespace ecods::exact {

// Whether a matrix is a bijection: exact, as the sign of the determinant is that of its columns and the origin.
inline bool is_regular(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) != Sign::zero;
}

// Whether it turns a right-handed frame to a left-handed one: exact, too.
inline bool is_mirror(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) == Sign::negative;
}

// Gives all bodies the identity for a pose if theirs are the same bits and regular: a common affine bijection changes
// no relation of theirs, and where they were modelled coordinates are shorter.
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
