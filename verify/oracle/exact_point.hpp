// The point R v + t in the numbers of a CGAL kernel.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include "ecods/pose.hpp"

namespace ecods::oracle {

// Intervals with correctly rounded ends; valid only while a FloatEnvironment lives.
using Interval = CGAL::Interval_nt_advanced;
using IntervalKernel = CGAL::Simple_cartesian<Interval>;
// Integers times powers of two: exact sums and products of doubles, three times as fast as rationals.
using ExactNumber = CGAL::Gmpzf;
using ExactKernel = CGAL::Simple_cartesian<ExactNumber>;
// Where points are constructed, which takes divisions.
using RationalKernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

// One coordinate of R v + t. With intervals no sum is a NaN: a finite double is no infinity, and directed rounding
// never makes a lower end +infinity or an upper end -infinity.
template <class Number>
Number posed_coordinate(const Pose& pose, const Vec3& v, int axis) {
    return Number(pose.R(axis, 0)) * Number(v[0]) + Number(pose.R(axis, 1)) * Number(v[1]) +
           Number(pose.R(axis, 2)) * Number(v[2]) + Number(pose.t[axis]);
}

template <class Kernel>
typename Kernel::Point_3 posed_point(const Pose& pose, const Vec3& v) {
    using Number = typename Kernel::FT;
    return {posed_coordinate<Number>(pose, v, 0), posed_coordinate<Number>(pose, v, 1),
            posed_coordinate<Number>(pose, v, 2)};
}

}  // namespace ecods::oracle
