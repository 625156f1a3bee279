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
    int sign_at(const mpz_class& num, unsigned long bits) const;  // at num / 2^bits

    friend Polynomial operator+(const Polynomial& f, const Polynomial& g);
    friend Polynomial operator-(const Polynomial& f, const Polynomial& g);
    friend Polynomial operator-(const Polynomial& f) { return Polynomial() - f; }
    friend Polynomial operator*(const Polynomial& f, const Polynomial& g);

  private:
    std::vector<mpz_class> c_;
};

// The greatest common divisor but for a constant factor; that of zero and zero is zero.
Polynomial gcd(const Polynomial& f, const Polynomial& g);

// f over g^k, but for a constant factor, with the largest k for which g^k divides f. Neither is zero; g is not
// constant.
Polynomial without_factor(Polynomial f, const Polynomial& g);

// A root, from 0 to 1, of a polynomial: a number, or the only root from low / 2^bits to (low + 1) / 2^bits, at which
// the polynomial has different signs.
class Root {
  public:
    Root(const mpq_class& number) : number_(number) {}
    Root(Polynomial polynomial, const mpz_class& low, unsigned long bits)
        : polynomial_(std::move(polynomial)), low_(low), bits_(bits), sign_at_low_(polynomial_.sign_at(low, bits)) {}

    bool is_exact() const { return sign_at_low_ == 0; }
    mpq_class low() const { return is_exact() ? number_ : end(0); }

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
    void find_exponent();
    mpq_class end(int which) const;  // 1: the upper one
    // Whether it is one of `common`, too, a divisor of its polynomial.
    bool is_root_of(const Polynomial& common) const;
    // The sign of the polynomial from low to high, 0 if this leaves it open.
    int sign_around(const Polynomial& g) const;

    mpq_class number_;
    Polynomial polynomial_;
    mpz_class low_;
    unsigned long bits_ = 0;
    int sign_at_low_ = 0;  // of the polynomial; 0: the root is the number
};

// Whether a polynomial of degree 3 or less surely has one sign from 0 to 1, and so no root.
bool has_one_sign(const Polynomial& f);

// All of a polynomial that is not zero, ascending.
std::vector<Root> roots_to_one(const Polynomial& f);

}  // namespace ecods::oracle
