// Roots and fractions in exact numbers: how they compare with doubles, and which double is the nearest.
//
// Shared with nothing: a double is the nearest if the number lies between the two points half-way to its neighbours,
// which is asked of integers by squaring these points. No root is taken and nothing is divided but for a first guess.
#pragma once

#include <gmpxx.h>

namespace ecods::oracle {

// The root of num / den, times 2^unit. num >= 0, den > 0.
struct ExactRoot {
    mpz_class num = 0;
    mpz_class den = 1;
    long unit = 0;

    bool is_zero() const { return sgn(num) == 0; }
};

// num / den times 2^unit. den > 0.
struct ExactFraction {
    mpz_class num = 0;
    mpz_class den = 1;
    long unit = 0;
};

// The sign of the root less the double d >= 0, which may be infinite.
int compare(const ExactRoot& root, double d);

// The sign of the first less the second.
int compare(const ExactRoot& first, const ExactRoot& second);

// Whether d is the double nearest to the root, ties to even, infinity from half-way above the largest double on, and at
// least 2^-1074 if the root is positive.
bool is_nearest(const ExactRoot& root, double d);
double nearest(const ExactRoot& root);

// The same of a fraction, but that small ones round to zero, which is +0.
bool is_nearest(const ExactFraction& fraction, double d);
double nearest(const ExactFraction& fraction);

}  // namespace ecods::oracle
