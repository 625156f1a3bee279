// Posing a point, rounded for the filter.
#pragma once

#include "ecods/pose.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// fl(R v + d), in the order of operations that point_error_bound is about.
inline Point pose_point(const Mat3& R, const Vec3& v, const Vec3& d) noexcept {
    Point p;
    for (int row = 0; row < 3; ++row) {
        p[static_cast<std::size_t>(row)] = ((R(row, 0) * v[0] + R(row, 1) * v[1]) + R(row, 2) * v[2]) + d[row];
    }
    return p;
}

}  // namespace ecods::exact
