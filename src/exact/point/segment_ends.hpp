// SegmentEnds computes the ends of two posed segments in the world as integers of one unit, of 121 binary digits.
// SegmentEnds is made for bodies of one point or segment: nothing is cached, and most ends take nine multiplications.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// A SegmentRef refers to the segment between R p + t and R q + t. A point has p and q at one address.
struct SegmentRef {
    const Pose* pose;
    const Vec3 *p, *q;

    bool is_point() const noexcept { return p == q; }
};

// A PointAndTriangle refers to a posed point and to the corners of a posed triangle.
struct PointAndTriangle {
    const Pose* pose_of_point;
    const Vec3* point;
    const Pose* pose;
    std::array<const Vec3*, 3> corners;
};

struct SegmentEnds {
    using Point = TwoLimbKernel::Point;

    // Computes the ends of segments a and b. Numbers that the caller will convert to the same unit must be below
    // 2^high. All numbers must be finite.
    SegmentEnds(const SegmentRef& a, const SegmentRef& b, int high) noexcept;

    // Makes the segment from corner p of the triangle to corner q, on side `of_triangle`, and on the other side the
    // segment from the point x to x - (r - p). The difference of the two segments' points at the parameters S and T is
    // the difference of x and p + S (r - p) + T (q - p), up to its sign. So the closest points of the segments are at
    // the S and T for which p + S (r - p) + T (q - p) is the foot of x in the triangle's plane, if S and T are in [0,
    // 1]. Ends that are not exact have the error bound of other ends.
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
