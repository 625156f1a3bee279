#include "ecods/pose.hpp"

#include <bit>
#include <cstdint>

#include "base/make_error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

Pose Pose::from_quaternion(double w, double x, double y, double z, const Vec3& t) {
    return {Eigen::Quaternion<double, Eigen::DontAlign>(w, x, y, z).toRotationMatrix(), t};
}

// Compares bits except for the sign of a zero: a NaN is no zero, and neither is a subnormal in any environment.
void Pose::require_last_row(double x, double y, double z, double w) {
    const double row[] = {x, y, z, w};
    for (int column = 0; column < 4; ++column) {
        const auto bits = std::bit_cast<std::uint64_t>(row[column]);
        const bool is_right = column == 3 ? bits == std::bit_cast<std::uint64_t>(1.0) : bits << 1 == 0;
        if (!is_right) throw invalid_pose(3, column, row[column]);
    }
}

void validate(const Pose& pose) {
    if (const auto bad = find_invalid(pose)) throw invalid_pose(bad->row, bad->column, bad->value);
}

}  // namespace ecods
