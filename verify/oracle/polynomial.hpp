// Polynomials with integer coefficients, and their real roots from 0 to 1, isolated by Sturm's sequences.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

namespace ecods::oracle {

// Coefficients from the constant one on; the last is not zero. Zero has none.
class Polynomial {
  public:
    Polynomial() = default;
    explicit Polynomial(int constant) : Polynomial(std::vector<mpz_class>{constant}) {}
    explicit Polynomial(std::vector<mpz_class> coefficients);

    bool is_zero() const { return c_.empty(); }
    bool is_constant() const { return c_.size() <= 1; }
    std::size_t degree() const { return c_.empty() ? 0 : c_.size() - 1; }
    const std::vector<mpz_class>& coefficients() const { return c_; }
    mpz_class coefficient(std::size_t i) const { return i < c_.size() ? c_[i] : mpz_class(0); }

    int sign_at(const mpq_class& x) const;

    friend Polynomial operator+(const Polynomial& f, const Polynomial& g);
    friend Polynomial operator-(const Polynomial& f, const Polynomial& g);
    friend Polynomial operator-(const Polynomial& f) { return Polynomial() - f; }
    friend Polynomial operator*(const Polynomial& f, const Polynomial& g);

  private:
    std::vector<mpz_class> c_;
};

// The greatest common divisor but for a constant factor; that of zero and zero is zero.
Polynomial gcd(const Polynomial& f, const Polynomial& g);

// A root, from 0 to 1, of a polynomial without double roots: exact if `low` is `high`; otherwise the only one between
// these, at which the polynomial has different signs.
class Root {
  public:
    Root(const mpq_class& number) : low_(number), high_(number) {}
    Root(Polynomial polynomial, mpq_class low, mpq_class high)
        : polynomial_(std::move(polynomial)), low_(std::move(low)), high_(std::move(high)) {}

    bool is_exact() const { return low_ == high_; }
    const mpq_class& low() const { return low_; }

    // The sign of the root less the number.
    int compare(const mpq_class& x) const;
    // The same of two roots. Intervals become narrower.
    int compare(Root& other);
    // The sign of the polynomial at the root.
    int sign_of(const Polynomial& g);

    // Rounded to the nearest double, ties to even, and at least 2^-1074 if it is positive.
    double nearest() const;

  private:
    void halve();

    Polynomial polynomial_;
    mpq_class low_, high_;
};

// Whether a polynomial of degree 3 or less surely has one sign from 0 to 1, and so no root.
bool has_one_sign(const Polynomial& f);

// All of a polynomial that is not zero, ascending.
std::vector<Root> roots_to_one(const Polynomial& f);

}  // namespace ecods::oracle
