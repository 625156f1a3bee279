// A Line is a segment or a ray, so that both can share code.
#pragma once

#include "ecods/primitives.hpp"

namespace ecods {

// Holds the points a + s d for all real s in [0, end]. For a segment d = b - a exactly, which need not be a double, and
// end = 1. For a ray d = b.
struct Line {
    explicit Line(const Segment& segment) : a(segment.a), b(segment.b), end(1), is_ray(false) {}
    explicit Line(const Ray& ray) : a(ray.origin), b(ray.direction), end(ray.max_parameter), is_ray(true) {}

    Vec3 a;
    Vec3 b;
    double end;
    bool is_ray;
};

}  // namespace ecods
