// Polynomials of degree three at most, with integer coefficients: how determinants of points that move on straight
// lines depend on time.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/integer.hpp"

namespace ecods::exact {

// The number m / 2^bits.
struct BinaryFraction {
    Integer m;
    int bits = 0;
};

class Polynomial {
  public:
    static constexpr int degree_max = 3;
    using Coefficients = std::array<Integer, degree_max + 1>;

    Polynomial() = default;
    // Of degree 1: constant + slope * s.
    Polynomial(Integer constant, Integer slope) : c_{std::move(constant), std::move(slope), {}, {}} {}
    explicit Polynomial(Coefficients coefficients) : c_(std::move(coefficients)) {}

    // -1 for zero.
    int degree() const noexcept;
    bool is_zero() const noexcept { return degree() < 0; }
    // Of the power i.
    const Integer& operator[](int i) const noexcept { return c_[static_cast<std::size_t>(i)]; }

    friend Polynomial operator+(const Polynomial& p, const Polynomial& q);
    friend Polynomial operator-(const Polynomial& p, const Polynomial& q);
    // The degrees add up to three at most.
    friend Polynomial operator*(const Polynomial& p, const Polynomial& q);

    // The sign of the value at a number.
    int sign_at(const BinaryFraction& s) const;
    // The same at the root of a polynomial of degree 1.
    int sign_at_root_of(const Polynomial& linear) const;

    // In x, where s = (m + x) / 2^bits: times 2^(bits * degree).
    Polynomial moved_to(const BinaryFraction& from) const;

    // Positive multiples of the coefficients in the basis of Bernstein of degree() on the interval from 0 to 1: the
    // first and the last have the signs of the values at the ends, and every value inside is a mean of them, with
    // positive weights. Then the same on the interval from m / 2^bits to (m + 1) / 2^bits.
    Coefficients on_unit_interval() const;
    Coefficients on_interval(const BinaryFraction& from) const { return moved_to(from).on_unit_interval(); }

    // The same polynomial divided by the power of two that divides all coefficients.
    void drop_zeros();

  private:
    Coefficients c_;
};

Polynomial derivative(const Polynomial& p);

// A greatest common divisor, but for a constant factor; that of zero and p is p. By remainders of multiples that need
// no fractions (Knuth, The Art of Computer Programming, volume 2, 4.6.1, algorithm R).
Polynomial gcd(Polynomial p, Polynomial q);

// How often the signs of the first degree + 1 coefficients change, zeros left out.
//
// Of the coefficients on an interval this is at least the number of roots inside, counted as often as they are
// multiple, and exceeds it by an even number (the rule of Descartes, for s / (1 - s)). Roots at the ends do not count.
int sign_changes(const Polynomial::Coefficients& coefficients, int degree) noexcept;

}  // namespace ecods::exact
