// Poses that only translate.
#pragma once

#include "ecods/pose.hpp"

namespace ecods {

inline Pose at(const Vec3& t) {
    Pose pose;
    pose.t = t;
    return pose;
}

inline Pose at(double x, double y = 0, double z = 0) {
    return at(Vec3(x, y, z));
}

}  // namespace ecods
