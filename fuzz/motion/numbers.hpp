// Numbers, points and matrices that poses are made of.
#pragma once

#include "ecods/pose.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

double sign(scenes::Random& random);                 // 1 or -1
int axis(scenes::Random& random);                    // 0 to 2
double neighbour(double x, scenes::Random& random);  // the next double above or below

// From 0 to about a unit: of few digits, any, or tiny beside the unit.
double any_radius(double unit, scenes::Random& random);

Vec3 half_integers(double reach, scenes::Random& random);  // multiples of 0.5, at most `reach`, in each direction
Vec3 any_offset(double reach, scenes::Random& random);

Mat3 signed_permutation(scenes::Random& random);
Mat3 integer_matrix(scenes::Random& random);    // of -2 to 2; may be singular
Mat3 integer_rotation(scenes::Random& random);  // times a number between 1 and 2: exactly orthogonal columns
Mat3 any_rotation(scenes::Random& random);

}  // namespace ecods::fuzz
