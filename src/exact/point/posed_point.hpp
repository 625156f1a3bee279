// posed_point computes a point of a posed body in numbers of any length.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/long_vector.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

inline ScaledLongVector exact_vector(const Vec3& v) {
    return {ScaledInteger(v[0]), ScaledInteger(v[1]), ScaledInteger(v[2])};
}

// Returns R v + t exactly, for the pose [R t].
inline ScaledLongVector posed_point(const Pose& pose, const Vec3& v) {
    PoseTerms terms;
    terms.set(pose, Vec3::Zero());
    std::array<BitRange, 3> digits_of_v;
    for (int k = 0; k < 3; ++k) digits_of_v[static_cast<std::size_t>(k)].include(decode(v[k]));
    const BitRange digits = terms.digits(digits_of_v);
    const int unit = digits.empty() ? 0 : digits.low;
    const LongVector p = terms.point_in<Integer>(unit, v);
    return {ScaledInteger(p[0], unit), ScaledInteger(p[1], unit), ScaledInteger(p[2], unit)};
}

}  // namespace ecods::exact
