// SegmentEnds computes the ends of two posed segments in the world as integers of one unit, of 121 binary digits. It is
// made for questions about two points or segments alone: nothing is cached, and most ends take nine multiplications.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// Refers to the segment between R p + t and R q + t. A point has p and q at one address.
struct SegmentRef {
    const Pose* pose;
    const Vec3 *p, *q;

    bool is_point() const noexcept { return p == q; }
};

// Refers to a posed point and to the corners of a posed triangle.
struct PointAndTriangle {
    const Pose* pose_of_point;
    const Vec3* point;
    const Pose* pose;
    std::array<const Vec3*, 3> corners;
};

struct SegmentEnds {
    using Point = TwoLimbKernel::Point;

    // Numbers that the caller will convert to this unit must be below 2^high. All numbers must be finite.
    SegmentEnds(const SegmentRef& a, const SegmentRef& b, int high) noexcept;

    // Makes the segment from corner p of the triangle to corner q, on side `of_triangle`, and on the other side the one
    // from the point x to x - (r - p). The difference of two points of these segments, at S and T, is then that of x
    // and p + S (r - p) + T (q - p), or of these with the opposite sign. So the segments are closest where x is closest
    // to the triangle's plane. Ends that are not exact have the error bound of other ends.
    SegmentEnds(const PointAndTriangle& refs, std::size_t of_triangle, int high) noexcept;

    // A coordinate is the sum of three products and a translation, each rounded down: it is less than 4 units too low,
    // and the difference of two coordinates is off by less than 4 units.
    static constexpr int error_units = 4;
    int error() const noexcept { return is_exact ? 0 : error_units; }

    std::array<std::array<Point, 2>, 2> at;  // [body][end], below 2^121; both ends of a point are the same
    std::array<bool, 2> is_point;
    int unit = 0;
    bool is_exact = true;
};

}  // namespace ecods::exact
