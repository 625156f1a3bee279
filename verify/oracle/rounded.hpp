// The oracle's answers about rounded bodies: those of the cores, and radii, in rational numbers.
//
// A number of theirs is the sum of a fraction and the root of one. How it compares with another fraction is asked by
// moving the fractions to one side and squaring once; the nearest double is looked for between all doubles, by halves.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <span>

#include "ecods/pose.hpp"
#include "oracle/distance.hpp"

namespace ecods::oracle {

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

  private:
    mpq_class square_;  // of the distance of the cores
    std::array<mpq_class, 2> radius_;
    std::array<std::array<mpq_class, 3>, 2> core_point_;
};

}  // namespace ecods::oracle
