// A posed triangle as what it really is: a triangle, a segment or a point.
#pragma once

#include <array>
#include <optional>

#include "ecods/pose.hpp"
#include "oracle/exact_point.hpp"

namespace ecods::oracle {

// Corners 0 to `dimension` span it, and are affinely independent. The pose is referred to, not copied.
struct Simplex {
    const Pose* pose = nullptr;
    int dimension = 2;
    std::array<Vec3, 3> corners;
    std::array<IntervalKernel::Point_3, 3> intervals;  // around the exact corners
    bool is_bounded = false;                           // intervals may decide: no sign of theirs can overflow
    std::optional<std::array<ExactKernel::Point_3, 3>> exact_corners;  // once they were needed

    // A corner in the numbers of the kernel.
    template <class Kernel>
    typename Kernel::Point_3 point(int corner) {
        return posed_point<Kernel>(*pose, corners[corner]);
    }
};

template <>
inline IntervalKernel::Point_3 Simplex::point<IntervalKernel>(int corner) {
    return intervals[corner];
}

template <>
inline ExactKernel::Point_3 Simplex::point<ExactKernel>(int corner) {
    if (!exact_corners) {
        exact_corners = {posed_point<ExactKernel>(*pose, corners[0]), posed_point<ExactKernel>(*pose, corners[1]),
                         posed_point<ExactKernel>(*pose, corners[2])};
    }
    return (*exact_corners)[corner];
}

// Works out which of the three it is. Needs a FloatEnvironment.
Simplex make_simplex(const Pose& pose, const std::array<Vec3, 3>& corners,
                     const std::array<IntervalKernel::Point_3, 3>& intervals);

}  // namespace ecods::oracle
