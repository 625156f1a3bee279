// StraightMove describes a body whose points move straight: from their places at one pose to their places at another
// pose, or all by one translation.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

struct StraightMove {
    // Returns the pose at the end; its translation is rounded once. A translation above 2^1020 is limited to 2^1020,
    // because bounds in doubles do not hold above it (moving_points.hpp).
    Pose rounded_end() const {
        if (!translation) return body.to;
        constexpr double unbounded = 0x1p1020;
        return {body.from.R, (body.from.t + *translation).cwiseMax(-unbounded).cwiseMin(unbounded)};
    }

    Moving<MeshShape> body;
    std::optional<Vec3> translation;  // if it is set, body.to is body.from
};

}  // namespace ecods
