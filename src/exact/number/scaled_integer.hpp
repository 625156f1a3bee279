// A ScaledInteger is an integer of any length times a power of two: sums and products of doubles, without rounding.
#pragma once

#include <utility>

#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"

namespace ecods::exact {

// A ScaledInteger is m * 2^e. A zero has e = 0.
class ScaledInteger {
  public:
    ScaledInteger() = default;
    ScaledInteger(double x) : ScaledInteger(decode(x)) {}  // x must be finite
    explicit ScaledInteger(const Dyadic& x) : m_(x.m), e_(x.e) {}
    ScaledInteger(Integer m, int e) : m_(std::move(m)), e_(m_.is_zero() ? 0 : e) {}

    int sign() const noexcept { return m_.sign(); }
    const Integer& m() const noexcept { return m_; }
    int e() const noexcept { return e_; }

    // Returns this number divided by 2^unit, which must divide this number.
    Integer in_units(int unit) const { return m_.is_zero() ? Integer() : m_ << (e_ - unit); }

    ScaledInteger operator-() const { return {-m_, e_}; }
    friend ScaledInteger operator*(const ScaledInteger& a, const ScaledInteger& b) {
        return {a.m_ * b.m_, a.e_ + b.e_};
    }
    friend ScaledInteger operator+(const ScaledInteger& a, const ScaledInteger& b) {
        if (a.sign() == 0) return b;
        if (b.sign() == 0) return a;
        const int unit = a.e_ < b.e_ ? a.e_ : b.e_;
        return {a.in_units(unit) + b.in_units(unit), unit};
    }
    friend ScaledInteger operator-(const ScaledInteger& a, const ScaledInteger& b) { return a + -b; }

    // Returns the sign of a - b.
    friend int compare(const ScaledInteger& a, const ScaledInteger& b) { return (a - b).sign(); }

  private:
    Integer m_;
    int e_ = 0;
};

}  // namespace ecods::exact
