// Two operations on quaternions that give the same bits on every machine. Eigen's own add up in an order that depends
// on the instruction set.
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace ecods::scenes {

inline Eigen::Quaterniond unit(double w, double x, double y, double z) {
    const double norm = std::sqrt((w * w + x * x) + (y * y + z * z));
    return {w / norm, x / norm, y / norm, z / norm};
}

// First b, then a; made a unit again.
inline Eigen::Quaterniond compose(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return unit((a.w() * b.w() - a.x() * b.x()) - (a.y() * b.y() + a.z() * b.z()),
                (a.w() * b.x() + a.x() * b.w()) + (a.y() * b.z() - a.z() * b.y()),
                (a.w() * b.y() + a.y() * b.w()) + (a.z() * b.x() - a.x() * b.z()),
                (a.w() * b.z() + a.z() * b.w()) + (a.x() * b.y() - a.y() * b.x()));
}

}  // namespace ecods::scenes
