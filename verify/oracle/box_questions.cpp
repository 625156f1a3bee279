#include "oracle/box_questions.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>

namespace ecods::oracle {
namespace {

using Rational = CGAL::Gmpq;

// Leaves the part of [from, to] of the parameter at which the coordinate a + x (b - a) is at least `min`, with the
// signs turned if `sign` is -1.
void clip(double a, double b, double min, int sign, Rational& from, Rational& to) {
    if (std::isinf(min)) {
        if ((min > 0) == (sign > 0)) to = from - 1;
        return;
    }
    const Rational start = sign * (Rational(a) - Rational(min));
    const Rational slope = sign * (Rational(b) - Rational(a));
    if (slope == 0) {
        if (start < 0) to = from - 1;
        return;
    }
    const Rational at = -start / slope;
    if (slope > 0) {
        from = std::max(from, at);
    } else {
        to = std::min(to, at);
    }
}

}  // namespace

bool segment_meets_box(const Vec3& a, const Vec3& b, const Aabb& box) {
    Rational from = 0, to = 1;
    for (int axis = 0; axis < 3; ++axis) {
        clip(a[axis], b[axis], box.min[axis], 1, from, to);
        clip(a[axis], b[axis], box.max[axis], -1, from, to);
        if (from > to) return false;
    }
    return true;
}

bool ball_meets_box(const Vec3& center, double radius, const Aabb& box) {
    if (std::isinf(radius)) return true;
    Rational square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = center[axis];
        const double nearest = x < box.min[axis] ? box.min[axis] : x > box.max[axis] ? box.max[axis] : x;
        if (std::isinf(nearest)) return false;  // a box at infinity
        const Rational distance = Rational(x) - Rational(nearest);
        square += distance * distance;
    }
    return square <= Rational(radius) * Rational(radius);
}

}  // namespace ecods::oracle
