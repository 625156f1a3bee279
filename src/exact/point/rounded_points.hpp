// Six posed points, rounded for the filter, with the bound on their error.
#pragma once

#include "exact/point/integer_width.hpp"
#include "exact/point/pose_point.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

struct RoundedPoints {
    SixRounded points;
    double delta;
};

// Relative to the translation of the first point's pose.
inline RoundedPoints round_points(const SixPoints& exact) noexcept {
    RoundedPoints result{{}, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        const Pose& pose = *exact[i].pose;
        const Vec3 offset = pose.t - exact[0].pose->t;
        result.points[i] = pose_point(pose.R, *exact[i].v, offset);
        result.delta = std::max(result.delta, point_error_bound(pose.R, exact[i].v->cwiseAbs(), offset));
    }
    return result;
}

// The same where every pose is the identity: the points are what they are.
inline RoundedPoints plain_points(const SixPoints& exact) noexcept {
    RoundedPoints result{{}, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        const Vec3& v = *exact[i].v;
        result.points[i] = {v[0], v[1], v[2]};
    }
    // Subnormal coordinates may be taken for zero.
    result.delta = 0x1p-1000;
    return result;
}

}  // namespace ecods::exact
