// Whether a matrix is a bijection.
#pragma once

#include "ecods/predicates.hpp"

namespace ecods::exact {

// Exact: the sign of the determinant, as that of the columns and the origin.
inline bool is_regular(const Mat3& R) noexcept {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) != Sign::zero;
}

}  // namespace ecods::exact
