// The oracle's answers about rounded bodies: those of the cores, and radii, in rational numbers.
//
// A number of theirs is the sum of a fraction and the root of one. How it compares with another fraction is asked by
// moving the fractions to one side and squaring once; the nearest double is looked for between all doubles, by halves.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "oracle/distance.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

// The number, without the processor's conversion, which may take a subnormal number for zero.
mpq_class exactly(double x);

// The middle of the double of these bits, which is not negative, and the next one; of the largest double and 2^1024.
mpq_class middle_above(std::uint64_t bits);

// fraction + factor * sqrt(square); square >= 0.
struct FractionAndRoot {
    mpq_class fraction, factor, square;

    int sign() const;
};

// The nearest double, ties to even, infinity from half-way above the largest double on; a zero is +0.
double nearest(const FractionAndRoot& number);

class RoundedDistance {
  public:
    // Of cores that are closest at these points, with these radii.
    RoundedDistance(const ExactClosest& cores, double radius_a, double radius_b);

    // The sign of the distance of the cores, less the radii, less d.
    int compare(double d) const;

    // 0 if the bodies share a point; a positive distance is at least 2^-1074.
    double distance() const;

    // The point of body 0 or 1; requires that the cores share none.
    Vec3 point(std::size_t body) const;

    // The distance less the radii, of either sign; where the cores contain each other in part, `inside`, minus the sum
    // of distance and radii. At least 2^-1074 in magnitude unless it is 0.
    double signed_distance(bool inside = false) const;

  private:
    mpq_class square_;  // of the distance of the cores
    std::array<mpq_class, 2> radius_;
    std::array<std::array<mpq_class, 3>, 2> core_point_;
};

using Points = std::vector<Vector<mpq_class>>;

// The vertices of a mesh at a pose.
Points posed_points(const Mesh& mesh, const Pose& pose);

// The square of the depth of the convex hulls of two lists of points that meet: the least distance of the origin from a
// plane through three of their differences that has all other differences on one side; 0 if there is no plane.
mpq_class squared_depth(const Points& a, const Points& b);

// Minus the sum of the depth and a radius, as nearest(), but at least 2^-1074 in magnitude unless it is 0.
double minus_depth(const mpq_class& squared_depth, double radius_a, double radius_b);

}  // namespace ecods::oracle
