// A Line is a segment or a ray as one type: the part of a line that a question is about.
#pragma once

#include "ecods/primitives.hpp"

namespace ecods {

// Holds the points a + s d for all real s from 0 to `end`, both included. For a segment d is b - a, which need not be a
// double, and the end is 1; for a ray d is b itself.
struct Line {
    explicit Line(const Segment& segment) : a(segment.a), b(segment.b), end(1), is_ray(false) {}
    explicit Line(const Ray& ray) : a(ray.origin), b(ray.direction), end(ray.max_parameter), is_ray(true) {}

    Vec3 a;
    Vec3 b;
    double end;
    bool is_ray;
};

}  // namespace ecods
