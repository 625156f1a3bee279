// A Polynomial has integer coefficients and a degree of at most three. Determinants of points that move on straight
// lines are such polynomials in time.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/integer.hpp"

namespace ecods::exact {

// Represents the number m / 2^bits.
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

    // Returns the degree; -1 for the zero polynomial.
    int degree() const noexcept;
    bool is_zero() const noexcept { return degree() < 0; }
    // Returns the coefficient of s^i.
    const Integer& operator[](int i) const noexcept { return c_[static_cast<std::size_t>(i)]; }

    friend Polynomial operator+(const Polynomial& p, const Polynomial& q);
    friend Polynomial operator-(const Polynomial& p, const Polynomial& q);
    // The degrees of p and q must add up to at most three.
    friend Polynomial operator*(const Polynomial& p, const Polynomial& q);

    // Returns the sign of the polynomial's value at s.
    int sign_at(const BinaryFraction& s) const;
    // Returns the sign of this polynomial's value at the root of `linear`, whose degree must be 1.
    int sign_at_root_of(const Polynomial& linear) const;

    // Returns 2^(bits * degree) times this polynomial as a polynomial in x, where s = (m + x) / 2^bits and from = m /
    // 2^bits.
    Polynomial moved_to(const BinaryFraction& from) const;

    // Return positive multiples of the degree() + 1 Bernstein coefficients on [0, 1], or on [m / 2^bits, (m + 1) /
    // 2^bits] for from = m / 2^bits. The first and the last coefficient have the signs of the values at the ends. Every
    // value inside the interval is a mean of the Bernstein coefficients with positive weights.
    Coefficients on_unit_interval() const;
    Coefficients on_interval(const BinaryFraction& from) const { return moved_to(from).on_unit_interval(); }

    // Divides all coefficients by the greatest power of two that divides each of them.
    void drop_zeros();

  private:
    Coefficients c_;
};

Polynomial derivative(const Polynomial& p);

// Returns a greatest common divisor, up to a constant factor. If p or q is zero, returns the other one. Pseudo-division
// avoids fractions (Knuth, The Art of Computer Programming, volume 2, 4.6.1, algorithm R).
Polynomial gcd(Polynomial p, Polynomial q);

// Counts the sign changes in the sequence of the first degree + 1 coefficients, ignoring zeros.
//
// By Descartes' rule of signs, applied to s / (1 - s): for Bernstein coefficients on an interval, the count is at least
// the number of roots strictly inside, counted with multiplicities, and exceeds it by an even number.
int sign_changes(const Polynomial::Coefficients& coefficients, int degree) noexcept;

}  // namespace ecods::exact
