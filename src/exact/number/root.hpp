// A Root is a root of a polynomial with integer coefficients, as an exact number: it can be compared, rounded, and put
// into other polynomials.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exact/number/polynomial.hpp"

namespace ecods::exact {

// Holds one real number in the interval from 0 to 1, 0 excluded. It is either a binary fraction, or the only root of a
// polynomial strictly between m / 2^bits and (m + 1) / 2^bits, and a simple root. Questions shorten the interval, and
// it stays shorter.
class Root {
  public:
    // Makes the number `value` itself.
    explicit Root(BinaryFraction value);
    // Makes the root of p between `from` and the next fraction; `local` is p moved there. The Bernstein coefficients of
    // p on that interval have one change of sign, and the first of them that is not zero has the sign `sign_below`.
    Root(Polynomial p, BinaryFraction from, Polynomial local, int sign_below);

    // Returns the sign of g at the number. The work is bounded: a common divisor of both polynomials proves a zero.
    int sign_of(const Polynomial& g);

    // Returns the sign of x - y.
    friend int compare(Root& x, Root& y);

    // Returns the nearest double, ties to even; at least 2^-1074.
    double round();
    // True if the number is above x, a positive double.
    bool is_above(double x);

  private:
    static int compare_with_fraction(Root& x, const BinaryFraction& y);

    // Shortens the interval until its ends have at least `bits` bits, or until the number is known as a fraction.
    void refine(int bits);
    // Shortens the interval to one of 2^gain_ equal parts, or to a half.
    void shorten();
    // Shortens the interval to the part that begins at part.m / 2^part.bits of its length.
    void move_to(const BinaryFraction& part);
    void set_fraction(const BinaryFraction& part);
    // Returns the one of 2^bits equal parts in which a straight line between the values at the ends is zero.
    std::int64_t guess(int bits) const;
    // True if the number is a root of `divisor`, which divides a polynomial that has the number as a root.
    bool is_root_of_divisor(const Polynomial& divisor) const;

    Polynomial p_;  // zero for a fraction
    BinaryFraction from_;
    Polynomial local_;  // p as a polynomial on the interval from 0 to 1: moved to from_
    int sign_below_ = 0;
    int gain_ = 1;
    bool is_fraction_ = false;
};

// Returns the roots of p in the interval from 0 to 1, 0 excluded, each once, ascending; the zero polynomial gets none.
std::vector<Root> roots_in_unit_interval(Polynomial p);

// Returns the roots of p in `count` intervals of length 2^-bits from `from` on, the left end excluded; all intervals
// are within [0, 1]. Returns nothing if one of them may have two or more roots.
std::optional<std::vector<Root>> simple_roots_in(Polynomial p, BinaryFraction from, int count);

}  // namespace ecods::exact
