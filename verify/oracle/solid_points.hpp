// The points of posed soups as integers in one unit, without intervals: what solids are asked about is small.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/distance.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

using SolidPoint = Vector<mpz_class>;
using RationalPoint = Vector<mpq_class>;

// The point R v + t.
RationalPoint posed(const Pose& pose, const Vec3& v);

struct IntegerTriangle {
    std::uint32_t index = 0;  // in the soup
    std::array<SolidPoint, 3> corners;
    std::array<Vec3, 3> vertices;  // without the pose
    SolidPoint normal;             // zero if the pose, or nothing but the pose, leaves no area
    SolidPoint low, high;          // its box

    bool has_area() const { return sgn(normal[0]) != 0 || sgn(normal[1]) != 0 || sgn(normal[2]) != 0; }
};

// Of each soup all triangles, or only those whose area without the pose is positive.
struct SoupChoice {
    const Soup* soup;
    bool takes_zero_area;
};
std::vector<std::vector<IntegerTriangle>> integer_triangles(std::span<const SoupChoice> soups);

// Whether the boxes share no point.
bool boxes_are_apart(const IntegerTriangle& a, const IntegerTriangle& b);

// Whether the corners of a triangle are not on one line.
bool has_area(const Mesh& mesh, std::uint32_t triangle);

// Whether the pose's matrix has no inverse.
bool is_singular(const Pose& pose);

mpz_class determinant(const SolidPoint& u, const SolidPoint& v, const SolidPoint& w);

}  // namespace ecods::oracle
