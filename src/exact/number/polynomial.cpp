#include "exact/number/polynomial.hpp"

#include <algorithm>
#include <utility>

#include "base/assert.hpp"

namespace ecods::exact {

int Polynomial::degree() const noexcept {
    int d = degree_max;
    while (d >= 0 && c_[static_cast<std::size_t>(d)].is_zero()) --d;
    return d;
}

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
    Polynomial result;
    for (std::size_t i = 0; i < p.c_.size(); ++i) result.c_[i] = p.c_[i] + q.c_[i];
    return result;
}

Polynomial operator-(const Polynomial& p, const Polynomial& q) {
    Polynomial result;
    for (std::size_t i = 0; i < p.c_.size(); ++i) result.c_[i] = p.c_[i] - q.c_[i];
    return result;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
    Polynomial result;
    const int degree_p = p.degree(), degree_q = q.degree();
    if (degree_p < 0 || degree_q < 0) return result;
    ECODS_ASSERT(degree_p + degree_q <= Polynomial::degree_max);
    for (int i = 0; i <= degree_p; ++i) {
        for (int j = 0; j <= degree_q; ++j) {
            Integer& c = result.c_[static_cast<std::size_t>(i + j)];
            c = i == 0 || j == degree_q ? p[i] * q[j] + c : c + p[i] * q[j];
        }
    }
    return result;
}

// Computes 2^(bits * degree) times the value at s = m / 2^bits, by Horner's scheme, and returns its sign.
int Polynomial::sign_at(const BinaryFraction& s) const {
    const int d = degree();
    if (d < 0) return 0;
    Integer value = (*this)[d];
    for (int i = d; i-- > 0;) value = value * s.m + ((*this)[i] << (s.bits * (d - i)));
    return value.sign();
}

// Computes a^d times the value at b / a, the root of `linear`, by Horner's scheme. a^d is negative if a is and d is
// odd: then the sign is changed.
int Polynomial::sign_at_root_of(const Polynomial& linear) const {
    ECODS_ASSERT(linear.degree() == 1);
    const int d = degree();
    if (d < 0) return 0;
    const Integer b = -linear[0];
    const Integer& a = linear[1];
    Integer value = (*this)[d], power = a;
    for (int i = d; i-- > 0;) {
        value = value * b + (*this)[i] * power;
        if (i > 0) power = power * a;
    }
    const int sign = value.sign();
    return d % 2 == 1 && a.sign() < 0 ? -sign : sign;
}

// Shifts the polynomial's argument by repeated sums and products by m (the method of Shaw and Traub).
Polynomial Polynomial::moved_to(const BinaryFraction& from) const {
    const int d = degree();
    Coefficients t;
    for (int i = 0; i <= d; ++i) {
        t[static_cast<std::size_t>(i)] = from.bits == 0 ? (*this)[i] : (*this)[i] << (from.bits * (d - i));
    }
    if (!from.m.is_zero()) {
        for (int i = 0; i < d; ++i) {
            for (int j = d; j-- > i;) {
                const auto at = static_cast<std::size_t>(j);
                t[at] = t[at] + t[at + 1] * from.m;
            }
        }
    }
    return Polynomial(std::move(t));
}

Polynomial::Coefficients Polynomial::on_unit_interval() const {
    const Coefficients& t = c_;
    switch (degree()) {
        case 1:
            return {t[0], t[0] + t[1], {}, {}};
        case 2: {
            Integer twice = t[0] + t[0] + t[1];
            return {t[0], twice, t[0] + t[1] + t[2], {}};
        }
        case 3: {
            const Integer thrice = t[0] + t[0] + t[0];
            const Integer first = thrice + t[1];
            return {t[0], first, first + t[1] + t[2], t[0] + t[1] + t[2] + t[3]};
        }
        default:
            return t;
    }
}

void Polynomial::drop_zeros() {
    int zeros = -1;
    for (const Integer& c : c_) {
        if (!c.is_zero()) zeros = zeros < 0 ? c.trailing_zeros() : std::min(zeros, c.trailing_zeros());
    }
    if (zeros <= 0) return;
    for (Integer& c : c_) c = c >> zeros;
}

Polynomial derivative(const Polynomial& p) {
    return Polynomial({p[1], p[2] + p[2], p[3] + p[3] + p[3], {}});
}

Polynomial gcd(Polynomial p, Polynomial q) {
    if (p.degree() < q.degree()) std::swap(p, q);
    while (!q.is_zero()) {
        const int d = q.degree();
        while (p.degree() >= d && !p.is_zero()) {
            // Replaces p by q[d] p - p[e] s^(e - d) q, in which the leading terms cancel.
            const int e = p.degree();
            Polynomial::Coefficients rest;
            for (int i = 0; i < e; ++i) {
                Integer& c = rest[static_cast<std::size_t>(i)];
                c = p[i] * q[d];
                if (i >= e - d) c = c - q[i - (e - d)] * p[e];
            }
            p = Polynomial(std::move(rest));
        }
        p.drop_zeros();
        std::swap(p, q);
    }
    return p;
}

int sign_changes(const Polynomial::Coefficients& coefficients, int degree) noexcept {
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
