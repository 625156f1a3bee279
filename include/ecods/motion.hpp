// A thing on its way from one pose to another.
#pragma once

#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// Each point v of `what` goes from R v + t of the one pose to that of the other, on a straight line and at constant
// speed, in the time from 0 to 1. The poses are copies; `what` is referred to and must outlive this.
template <class T>
struct Moving {
    Moving(const T& thing, const Pose& start, const Pose& end) : what(&thing), from(start), to(end) {}
    Moving(const T&& thing, const Pose& start, const Pose& end) = delete;  // a temporary, which would be gone

    const T* what;  // never null
    Pose from;
    Pose to;
};

// Throws InvalidArgument if a coordinate of the vector is not finite.
ECODS_API void validate_motion(const Vec3& motion);

}  // namespace ecods
