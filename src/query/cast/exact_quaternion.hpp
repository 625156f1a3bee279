// An ExactQuaternion is a quaternion with exact components, of any length but zero. It computes its rotation exactly.
#pragma once

#include "ecods/pose.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/point/vectors.hpp"

namespace ecods {

struct ExactQuaternion {
    exact::ScaledInteger w;
    exact::ScaledLongVector v;

    exact::ScaledInteger norm() const { return w * w + dot(v, v); }
    // Returns the rotated vector g, times the norm of the quaternion: turning_triangles.hpp has the formula.
    exact::ScaledLongVector rotated(const exact::ScaledLongVector& g) const {
        const exact::ScaledLongVector once = cross(v, g), half = plus(times(once, w), cross(v, once));
        return plus(times(g, norm()), plus(half, half));
    }
};

inline ExactQuaternion exact_quaternion(const Quaternion& q) {
    return {q.w, {exact::ScaledInteger(q.x), exact::ScaledInteger(q.y), exact::ScaledInteger(q.z)}};
}

// Returns z1 times the conjugate of z0: a positive multiple of the quaternion that rotates from z0 to z1.
inline ExactQuaternion times_conjugate(const ExactQuaternion& z1, const ExactQuaternion& z0) {
    return {z1.w * z0.w + dot(z1.v, z0.v), minus(minus(times(z1.v, z0.w), times(z0.v, z1.w)), cross(z1.v, z0.v))};
}

// Returns x0 + s (x1 - x0) for numbers and vectors.
inline exact::ScaledInteger part_of_way(const exact::ScaledInteger& x0, const exact::ScaledInteger& x1,
                                        const exact::ScaledInteger& s) {
    return x0 + s * (x1 - x0);
}
inline exact::ScaledLongVector part_of_way(const exact::ScaledLongVector& x0, const exact::ScaledLongVector& x1,
                                           const exact::ScaledInteger& s) {
    return plus(x0, times(minus(x1, x0), s));
}

}  // namespace ecods
