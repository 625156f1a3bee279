// A Root is an exact real number: a root of a polynomial with integer coefficients, of the type P. Roots can be
// compared and rounded, and the signs of other polynomials at a root can be computed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exact/number/polynomial.hpp"

namespace ecods::exact {

// A RootOf holds a real number in (0, 1]: either a binary fraction, or the only root of a polynomial strictly between m
// / 2^bits and (m + 1) / 2^bits, which must be a simple root. Functions may shorten the interval, and keep the shorter
// one.
template <class P>
class RootOf {
  public:
    // Makes the root that is equal to `value`.
    explicit RootOf(BinaryFraction value);
    // Makes the root of p between `from` and the next fraction with the same denominator. `local` is p.moved_to(from).
    // The Bernstein coefficients of p on that interval must have exactly one change of sign. `sign_below` is the sign
    // of the first coefficient that is not zero.
    RootOf(P p, BinaryFraction from, P local, int sign_below);

    // Returns the sign of g at this number. The interval is shortened until the sign is certain; a common divisor of
    // both polynomials proves that the value is zero, which bounds the work.
    int sign_of(const P& g);

    // Returns the sign of x - y. The call may shorten the intervals of x and y.
    friend int compare(RootOf& x, RootOf& y) { return compare_roots(x, y); }

    // Returns the double nearest to this number, ties to even, but at least 2^-1074.
    double round();
    // Returns true if this number is greater than x, which must be a positive double.
    bool is_above(double x);

  private:
    static int compare_roots(RootOf& x, RootOf& y);
    static int compare_with_fraction(RootOf& x, const BinaryFraction& y);

    // Shortens the interval until its denominator is at least 2^bits, or until the number is known as a fraction.
    void refine(int bits);
    // Shortens the interval to one of its 2^gain_ equal parts, or to one of its halves.
    void shorten();
    // Shortens the interval to part number part.m (from 0) of its 2^part.bits equal parts.
    void move_to(const BinaryFraction& part);
    void set_fraction(const BinaryFraction& part);
    // Returns the number (from 0) of the one of the interval's 2^bits equal parts in which the straight line between
    // the values at both ends is zero.
    std::int64_t guess(int bits) const;
    // Returns true if this number is a root of `divisor`. `divisor` must divide a polynomial that has this number as
    // its only root in the interval.
    bool is_root_of_divisor(const P& divisor) const;

    P p_;  // zero polynomial if is_fraction_
    BinaryFraction from_;
    P local_;  // a multiple of p_.moved_to(from_): the interval is [0, 1]
    int sign_below_ = 0;
    int gain_ = 1;
    bool is_fraction_ = false;
};

using Root = RootOf<Polynomial>;

// Returns the roots of p in (0, 1], each once, in ascending order; an empty list for the zero polynomial.
template <class P = Polynomial>
std::vector<RootOf<P>> roots_in_unit_interval(P p);

// Returns the roots of p in the `count` consecutive intervals of length 2^-bits that begin at `from` = m / 2^bits; the
// left end of the first one is excluded. All intervals must be within [0, 1]. Returns nullopt if an interval may
// contain two or more roots.
template <class P = Polynomial>
std::optional<std::vector<RootOf<P>>> simple_roots_in(P p, BinaryFraction from, int count);

}  // namespace ecods::exact
