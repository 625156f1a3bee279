#include "ecods/pose.hpp"

#include <bit>
#include <cstdint>

#include "base/make_error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

Pose Pose::from_quaternion(double w, double x, double y, double z, const Vec3& t) {
    return {Eigen::Quaternion<double, Eigen::DontAlign>(w, x, y, z).toRotationMatrix(), t};
}

// Throws InvalidArgument unless the row is (0, 0, 0, 1). Compares bits, ignoring the sign of zeros, so that neither NaN
// nor a subnormal number passes as zero in any floating-point environment.
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
