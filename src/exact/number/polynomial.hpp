// A Polynomial has degree three at most and integer coefficients: determinants of points that move on straight lines
// are such polynomials of time.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/integer.hpp"

namespace ecods::exact {

// Holds the number m / 2^bits.
struct BinaryFraction {
    Integer m;
    int bits = 0;
};

class Polynomial {
  public:
    static constexpr int degree_max = 3;
    using Coefficients = std::array<Integer, degree_max + 1>;

    Polynomial() = default;
    // Makes the polynomial constant + slope * s.
    Polynomial(Integer constant, Integer slope) : c_{std::move(constant), std::move(slope), {}, {}} {}
    explicit Polynomial(Coefficients coefficients) : c_(std::move(coefficients)) {}

    // Returns -1 for the zero polynomial.
    int degree() const noexcept;
    bool is_zero() const noexcept { return degree() < 0; }
    // Returns the coefficient of s^i.
    const Integer& operator[](int i) const noexcept { return c_[static_cast<std::size_t>(i)]; }

    friend Polynomial operator+(const Polynomial& p, const Polynomial& q);
    friend Polynomial operator-(const Polynomial& p, const Polynomial& q);
    // Needs degrees that add up to three at most.
    friend Polynomial operator*(const Polynomial& p, const Polynomial& q);

    // Returns the sign of the value at s.
    int sign_at(const BinaryFraction& s) const;
    // Returns the sign of the value at the root of `linear`, which has degree 1.
    int sign_at_root_of(const Polynomial& linear) const;

    // Substitutes s = (m + x) / 2^bits: returns 2^(bits * degree) times this polynomial, as a polynomial in x.
    Polynomial moved_to(const BinaryFraction& from) const;

    // Returns positive multiples of the Bernstein coefficients of degree() on the interval from 0 to 1, or from
    // m / 2^bits to (m + 1) / 2^bits. The first and the last coefficient have the signs of the values at the ends.
    // Every value inside is a mean of the Bernstein coefficients with positive weights.
    Coefficients on_unit_interval() const;
    Coefficients on_interval(const BinaryFraction& from) const { return moved_to(from).on_unit_interval(); }

    // Divides the coefficients by the greatest power of two that divides all of them.
    void drop_zeros();

  private:
    Coefficients c_;
};

Polynomial derivative(const Polynomial& p);

// Returns a greatest common divisor, up to a constant factor; of zero and p it is p. Pseudo-division avoids fractions
// (Knuth, The Art of Computer Programming, volume 2, 4.6.1, algorithm R).
Polynomial gcd(Polynomial p, Polynomial q);

// Counts the sign changes in the first degree + 1 coefficients, zeros left out.
//
// Descartes' rule of signs, for s / (1 - s): for Bernstein coefficients on an interval, the count is at least the
// number of roots strictly inside, with their multiplicities, and exceeds it by an even number.
int sign_changes(const Polynomial::Coefficients& coefficients, int degree) noexcept;

}  // namespace ecods::exact
