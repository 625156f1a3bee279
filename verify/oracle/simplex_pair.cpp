#include "oracle/simplex_pair.hpp"

#include <CGAL/Uncertain.h>
#include <CGAL/intersections.h>

#include <boost/variant.hpp>

namespace ecods::oracle {
namespace {

template <class Kernel>
typename Kernel::Triangle_3 triangle(Simplex& s) {
    return {s.point<Kernel>(0), s.point<Kernel>(1), s.point<Kernel>(2)};
}

template <class Kernel>
typename Kernel::Segment_3 segment(Simplex& s) {
    return {s.point<Kernel>(0), s.point<Kernel>(1)};
}

bool triangles_intersect(Simplex& a, Simplex& b) {
    if (a.is_bounded && b.is_bounded) {
        try {
            return CGAL::do_intersect(triangle<IntervalKernel>(a), triangle<IntervalKernel>(b));
        } catch (const CGAL::Uncertain_conversion_exception&) {
        }
    }
    return CGAL::do_intersect(triangle<ExactKernel>(a), triangle<ExactKernel>(b));
}

// Whether points of `s` lie strictly on either side of the plane of the triangle `t`.
template <class Kernel>
bool is_two_sided(Simplex& t, Simplex& s) {
    bool positive = false;
    bool negative = false;
    for (int i = 0; i <= s.dimension; ++i) {
        const CGAL::Orientation side =
            CGAL::orientation(t.point<Kernel>(0), t.point<Kernel>(1), t.point<Kernel>(2), s.point<Kernel>(i));
        positive |= side == CGAL::POSITIVE;
        negative |= side == CGAL::NEGATIVE;
    }
    return positive && negative;
}

bool is_two_sided(Simplex& t, Simplex& s) {
    if (t.is_bounded && s.is_bounded) {
        try {
            return is_two_sided<IntervalKernel>(t, s);
        } catch (const CGAL::Uncertain_conversion_exception&) {
        }
    }
    return is_two_sided<ExactKernel>(t, s);
}

using Point = RationalKernel::Point_3;

bool is_inside(const RationalKernel::Triangle_3& t, const Point& p) {
    for (int i = 0; i < 3; ++i) {
        if (CGAL::coplanar_orientation(t[i], t[i + 1], t[i + 2], p) != CGAL::POSITIVE) return false;
    }
    return true;
}

bool is_inside(const RationalKernel::Segment_3& s, const Point& p) {
    return p != s.source() && p != s.target();
}

// A point of the relative interior of an intersection that is not two-dimensional.
struct InteriorPoint : boost::static_visitor<Point> {
    Point operator()(const Point& p) const { return p; }
    Point operator()(const RationalKernel::Segment_3& s) const { return CGAL::midpoint(s.source(), s.target()); }
    template <class Polygon>
    Point operator()(const Polygon&) const {
        throw std::logic_error("oracle: simplices that are not coplanar meet in a polygon");
    }
};

// Of convex sets whose relative interiors meet, the relative interior of the intersection is the intersection of the
// relative interiors (Rockafellar, Convex Analysis, theorem 6.5). So one point of it decides.
template <class Other>
bool interiors_meet(const RationalKernel::Triangle_3& a, const Other& b) {
    const auto common = CGAL::intersection(a, b);
    if (!common) throw std::logic_error("oracle: simplices that share a point have no intersection");
    const Point p = boost::apply_visitor(InteriorPoint(), *common);
    return is_inside(a, p) && is_inside(b, p);
}

}  // namespace

bool intersects(Simplex& a, Simplex& b) {
    if (a.dimension < b.dimension) return intersects(b, a);
    if (b.dimension == 2) return triangles_intersect(a, b);
    if (b.dimension == 1) {
        return a.dimension == 2 ? CGAL::do_intersect(triangle<ExactKernel>(a), segment<ExactKernel>(b))
                                : CGAL::do_intersect(segment<ExactKernel>(a), segment<ExactKernel>(b));
    }
    const ExactKernel::Point_3 p = b.point<ExactKernel>(0);
    if (a.dimension == 2) return CGAL::do_intersect(triangle<ExactKernel>(a), p);
    if (a.dimension == 1) return segment<ExactKernel>(a).has_on(p);
    return a.point<ExactKernel>(0) == p;
}

bool is_crossing(Simplex& a, Simplex& b) {
    if (a.dimension < b.dimension) return is_crossing(b, a);
    // Segments that meet lie in one plane, and so does a point with whatever it lies on.
    if (a.dimension < 2 || b.dimension == 0) return false;
    // The relative interior of what lies on one side of a plane, and not in it, does not meet the plane.
    if (!is_two_sided(a, b)) return false;
    if (b.dimension == 1) return interiors_meet(triangle<RationalKernel>(a), segment<RationalKernel>(b));
    return is_two_sided(b, a) && interiors_meet(triangle<RationalKernel>(a), triangle<RationalKernel>(b));
}

}  // namespace ecods::oracle
