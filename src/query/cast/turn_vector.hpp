// vector_of() returns the vector part of a turn's quaternion.
#pragma once

#include "ecods/pose.hpp"

namespace ecods {

inline Vec3 vector_of(const Quaternion& q) {
    return {q.x, q.y, q.z};
}

}  // namespace ecods
