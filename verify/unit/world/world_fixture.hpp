// Poses and small assertions for the tests of World.
#pragma once

#include <vector>

#include "ecods/world.hpp"

namespace ecods {

inline Pose at(double x, double y = 0, double z = 0) {
    Pose pose;
    pose.t = Vec3(x, y, z);
    return pose;
}

inline std::vector<BodyPair> list(std::span<const BodyPair> pairs) {
    return {pairs.begin(), pairs.end()};
}

}  // namespace ecods
