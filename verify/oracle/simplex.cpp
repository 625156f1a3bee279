#include "oracle/simplex.hpp"

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ecods::oracle {
namespace {

// A 3x3 determinant of differences of coordinates below 2^300 stays below 6 (2^301)^3 < 2^906: no infinity arises,
// hence no 0 * infinity, in the intervals of any orientation predicate.
bool is_bounded_point(const IntervalKernel::Point_3& point) {
    const double limit = std::ldexp(1.0, 300);
    const auto inside = [limit](const Interval& x) { return -limit < x.inf() && x.sup() < limit; };
    return inside(point.x()) && inside(point.y()) && inside(point.z());
}

template <class Kernel>
bool is_collinear(Simplex& simplex) {
    return CGAL::collinear(simplex.point<Kernel>(0), simplex.point<Kernel>(1), simplex.point<Kernel>(2));
}

bool is_collinear(Simplex& simplex) {
    if (simplex.is_bounded) {
        try {
            return is_collinear<IntervalKernel>(simplex);
        } catch (const CGAL::Uncertain_conversion_exception&) {
        }
    }
    return is_collinear<ExactKernel>(simplex);
}

void swap_corners(Simplex& simplex, int i, int j) {
    std::swap(simplex.corners[i], simplex.corners[j]);
    std::swap(simplex.intervals[i], simplex.intervals[j]);
    if (simplex.exact_corners) std::swap((*simplex.exact_corners)[i], (*simplex.exact_corners)[j]);
}

// Puts the ends of three collinear corners first. Along a line, the order of the points is the lexicographic one.
void reduce_to_segment_or_point(Simplex& simplex) {
    std::array<ExactKernel::Point_3, 3> points;
    for (int i = 0; i < 3; ++i) points[i] = simplex.point<ExactKernel>(i);
    int first = 0;
    int last = 0;
    for (int i = 1; i < 3; ++i) {
        if (CGAL::lexicographically_xyz_smaller(points[i], points[first])) first = i;
        if (CGAL::lexicographically_xyz_smaller(points[last], points[i])) last = i;
    }
    simplex.dimension = first == last ? 0 : 1;
    swap_corners(simplex, 0, first);
    if (simplex.dimension == 1) swap_corners(simplex, 1, last == 0 ? first : last);
}

}  // namespace

Simplex make_simplex(const Pose& pose, const std::array<Vec3, 3>& corners,
                     const std::array<IntervalKernel::Point_3, 3>& intervals) {
    Simplex simplex;
    simplex.pose = &pose;
    simplex.corners = corners;
    simplex.intervals = intervals;
    simplex.is_bounded = std::all_of(intervals.begin(), intervals.end(), is_bounded_point);
    if (is_collinear(simplex)) reduce_to_segment_or_point(simplex);
    return simplex;
}

}  // namespace ecods::oracle
