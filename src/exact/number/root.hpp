// Roots of polynomials with integer coefficients, as exact numbers: compared, rounded, and put into other polynomials.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exact/number/polynomial.hpp"

namespace ecods::exact {

// One real number in the interval from 0 to 1, 0 excluded: a binary fraction, or the only root of a polynomial strictly
// between two neighbouring ones m / 2^bits and (m + 1) / 2^bits, and simple there. What a question learns of it is
// kept: the interval becomes shorter.
class Root {
  public:
    // The fraction itself.
    explicit Root(BinaryFraction value);
    // The root of p between `from` and the next fraction; `local` is p moved there. On that interval the coefficients
    // of p have one change of sign, which begins with `sign_below`.
    Root(Polynomial p, BinaryFraction from, Polynomial local, int sign_below);

    // The sign of g there. Bounded: a common divisor of both polynomials proves a zero.
    int sign_of(const Polynomial& g);

    // The sign of the difference from another root.
    friend int compare(Root& x, Root& y);

    // The double nearest to it, ties to even; at least 2^-1074.
    double round();
    // Whether it is above a positive double.
    bool is_above(double x);

  private:
    static int compare_with_fraction(Root& x, const BinaryFraction& y);

    // Shortens the interval until fractions have at least so many bits, or it is one itself.
    void refine(int bits);
    // To one of 2^gain_ parts of it, or to its half.
    void shorten();
    // To the part that begins at m / 2^bits of it.
    void move_to(const BinaryFraction& part);
    void set_fraction(const BinaryFraction& part);
    // Where a straight line between the values at the ends would be zero: in which of 2^bits parts.
    std::int64_t guess(int bits) const;
    // Whether a divisor of a polynomial of which this is a root has it, too.
    bool is_root_of_divisor(const Polynomial& divisor) const;

    Polynomial p_;  // zero for a fraction
    BinaryFraction from_;
    Polynomial local_;  // p on the interval, as on that from 0 to 1
    int sign_below_ = 0;
    int gain_ = 1;
    bool is_fraction_ = false;
};

// The roots of p in the interval from 0 to 1, 0 excluded, each once, ascending; of the zero polynomial none.
std::vector<Root> roots_in_unit_interval(Polynomial p);

// Those in `count` intervals of the length 2^-bits from `from` on, the left end excluded; all are within the interval
// from 0 to 1. Nothing where these are not short enough to part the roots: where two or more may be in one of them.
std::optional<std::vector<Root>> simple_roots_in(Polynomial p, BinaryFraction from, int count);

}  // namespace ecods::exact
