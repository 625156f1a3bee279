// A Polynomial has integer coefficients and a limited degree. Determinants of moving points are polynomials in time: of
// degree three at most if the points move on straight lines, or if only one body turns; of degree five at most if both
// bodies turn.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "exact/number/integer.hpp"

namespace ecods::exact {

// A BinaryFraction is the number m / 2^bits.
struct BinaryFraction {
    Integer m;
    int bits = 0;
};

template <int degree_limit>
class PolynomialOf {
  public:
    static constexpr int degree_max = degree_limit;
    using Coefficients = std::array<Integer, degree_max + 1>;

    PolynomialOf() = default;
    // Makes the polynomial constant + slope * s.
    PolynomialOf(Integer constant, Integer slope) : c_{std::move(constant), std::move(slope)} {}
    explicit PolynomialOf(Coefficients coefficients) : c_(std::move(coefficients)) {}

    // Returns the degree; -1 for the zero polynomial.
    int degree() const noexcept;
    bool is_zero() const noexcept { return degree() < 0; }
    // Returns the coefficient of s^i.
    const Integer& operator[](int i) const noexcept { return c_[static_cast<std::size_t>(i)]; }

    friend PolynomialOf operator+(const PolynomialOf& p, const PolynomialOf& q) { return sum(p, q); }
    friend PolynomialOf operator-(const PolynomialOf& p, const PolynomialOf& q) { return difference(p, q); }
    // Returns the product of p and q, whose degrees must add up to at most degree_max.
    friend PolynomialOf operator*(const PolynomialOf& p, const PolynomialOf& q) { return product(p, q); }

    // Returns the sign of the polynomial's value at s.
    int sign_at(const BinaryFraction& s) const;
    // Returns the sign of this polynomial's value at the root of `linear`, whose degree must be 1.
    int sign_at_root_of(const PolynomialOf& linear) const;

    // Returns 2^(bits * degree) times this polynomial as a polynomial in x, where s = (m + x) / 2^bits and from = m /
    // 2^bits.
    PolynomialOf moved_to(const BinaryFraction& from) const;

    // Return positive multiples of the degree() + 1 Bernstein coefficients on [0, 1], or on [m / 2^bits, (m + 1) /
    // 2^bits] for from = m / 2^bits. The first and the last coefficient have the signs of the values at the ends. Every
    // value inside the interval is a mean of the Bernstein coefficients with positive weights.
    Coefficients on_unit_interval() const;
    Coefficients on_interval(const BinaryFraction& from) const { return moved_to(from).on_unit_interval(); }

    // Divides all coefficients by the greatest power of two that divides each of them.
    void drop_zeros();

  private:
    static PolynomialOf sum(const PolynomialOf& p, const PolynomialOf& q);
    static PolynomialOf difference(const PolynomialOf& p, const PolynomialOf& q);
    static PolynomialOf product(const PolynomialOf& p, const PolynomialOf& q);

    Coefficients c_;
};

using Polynomial = PolynomialOf<3>;
using Quintic = PolynomialOf<5>;

template <int degree_max>
PolynomialOf<degree_max> derivative(const PolynomialOf<degree_max>& p);

// Returns a greatest common divisor, up to a constant factor. If p or q is zero, returns the other one. Pseudo-division
// avoids fractions (Knuth, The Art of Computer Programming, volume 2, 4.6.1, algorithm R).
template <int degree_max>
PolynomialOf<degree_max> gcd(PolynomialOf<degree_max> p, PolynomialOf<degree_max> q);

// Returns p divided by `divisor`, up to a constant factor. `divisor` must divide p, and not be zero.
template <int degree_max>
PolynomialOf<degree_max> quotient(PolynomialOf<degree_max> p, const PolynomialOf<degree_max>& divisor);

// Returns true if the polynomials certainly have no common root, because they have none modulo a prime. Polynomials
// without a common root are almost always recognized. Cost: below that of a product of two coefficients for each
// coefficient.
template <int degree_max>
bool are_coprime(const PolynomialOf<degree_max>& p, const PolynomialOf<degree_max>& q) noexcept;

// Returns the number of sign changes in the sequence of the first degree + 1 coefficients, ignoring zeros.
//
// By Descartes' rule of signs, applied to s / (1 - s): for Bernstein coefficients on an interval, the count is at least
// the number of roots strictly inside, counted with multiplicities, and exceeds it by an even number.
template <std::size_t count>
int sign_changes(const std::array<Integer, count>& coefficients, int degree) noexcept {
    int changes = 0, last = 0;
    for (int i = 0; i <= degree; ++i) {
        const int sign = coefficients[static_cast<std::size_t>(i)].sign();
        if (sign == 0) continue;
        changes += last != 0 && sign != last;
        last = sign;
    }
    return changes;
}

}  // namespace ecods::exact
