// The oracle's hits: what include/ecods/hit.hpp promises, in rationals, triangle by triangle, and without a tree.
//
// Every point of a triangle, of a segment and of a single point is what some linear equations and inequalities allow.
// On a line these are of one number, the parameter: each leaves all of the parameters, some from or up to a fraction,
// one or none.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <vector>

#include "oracle/distance.hpp"

namespace ecods::oracle {

// As the kinds of include/ecods/hit.hpp, in their order.
enum class HitWay { front, back, face, edge, vertex, along };

struct ExactHit {
    HitWay way = HitWay::front;
    NamedFeature feature;
    mpq_class enter, leave;
    std::uint32_t rank = 0;
    ExactPoint point, leave_point;
};

// The segment from `from` to `to`; or the ray from `from` along `to`, as far as `max_parameter`, which may be infinite.
struct ExactLine {
    Vec3 from, to;
    bool is_ray = false;
    double max_parameter = 1;
};

// Every triangle of the posed mesh that is hit, ascending by parameter, then by triangle.
std::vector<ExactHit> all_hits(const ExactLine& line, const Soup& soup);

// Rounded once, a positive one to at least 2^-1074.
double nearest_parameter(const mpq_class& parameter);

}  // namespace ecods::oracle
