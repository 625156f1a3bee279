#include "exact/number/polynomial.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/assert.hpp"

namespace ecods::exact {

template <int degree_limit>
int PolynomialOf<degree_limit>::degree() const noexcept {
    int d = degree_max;
    while (d >= 0 && c_[static_cast<std::size_t>(d)].is_zero()) --d;
    return d;
}

template <int degree_limit>
PolynomialOf<degree_limit> PolynomialOf<degree_limit>::sum(const PolynomialOf& p, const PolynomialOf& q) {
    PolynomialOf result;
    for (std::size_t i = 0; i < p.c_.size(); ++i) result.c_[i] = p.c_[i] + q.c_[i];
    return result;
}

template <int degree_limit>
PolynomialOf<degree_limit> PolynomialOf<degree_limit>::difference(const PolynomialOf& p, const PolynomialOf& q) {
    PolynomialOf result;
    for (std::size_t i = 0; i < p.c_.size(); ++i) result.c_[i] = p.c_[i] - q.c_[i];
    return result;
}

template <int degree_limit>
PolynomialOf<degree_limit> PolynomialOf<degree_limit>::product(const PolynomialOf& p, const PolynomialOf& q) {
    PolynomialOf result;
    const int degree_p = p.degree(), degree_q = q.degree();
    if (degree_p < 0 || degree_q < 0) return result;
    ECODS_ASSERT(degree_p + degree_q <= degree_max);
    for (int i = 0; i <= degree_p; ++i) {
        for (int j = 0; j <= degree_q; ++j) {
            Integer& c = result.c_[static_cast<std::size_t>(i + j)];
            c = i == 0 || j == degree_q ? p[i] * q[j] + c : c + p[i] * q[j];
        }
    }
    return result;
}

// Returns the sign of the polynomial's value at s = m / 2^bits, from 2^(bits * degree) times this value, by Horner's
// scheme.
template <int degree_limit>
int PolynomialOf<degree_limit>::sign_at(const BinaryFraction& s) const {
    const int d = degree();
    if (d < 0) return 0;
    Integer value = (*this)[d];
    for (int i = d; i-- > 0;) value = value * s.m + ((*this)[i] << (s.bits * (d - i)));
    return value.sign();
}

// Returns the sign of the value at the root b / a of `linear`. Horner's scheme computes a^d times the value, where d is
// the degree. If a is negative and d is odd, a^d is negative, and the sign is changed.
template <int degree_limit>
int PolynomialOf<degree_limit>::sign_at_root_of(const PolynomialOf& linear) const {
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

// Returns the polynomial with its argument shifted by from = m / 2^bits, by repeated sums and products by m (the method
// of Shaw and Traub).
template <int degree_limit>
PolynomialOf<degree_limit> PolynomialOf<degree_limit>::moved_to(const BinaryFraction& from) const {
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
    return PolynomialOf(std::move(t));
}

// Returns multiples of the Bernstein coefficients on [0, 1]. For coefficients t_i and the degree n, the Bernstein
// coefficient j, times the binomial n over j, is the sum over i of t_i times the binomial n - i over j - i. These sums
// are the coefficients of the sum over i of t_i s^i (1 + s)^(n - i), which repeated sums compute.
template <int degree_limit>
auto PolynomialOf<degree_limit>::on_unit_interval() const -> Coefficients {
    Coefficients t = c_;
    for (int last = degree(); last > 0; --last) {
        for (int i = 1; i <= last; ++i) {
            const auto at = static_cast<std::size_t>(i);
            t[at] = t[at] + t[at - 1];
        }
    }
    return t;
}

template <int degree_limit>
void PolynomialOf<degree_limit>::drop_zeros() {
    int zeros = -1;
    for (const Integer& c : c_) {
        if (!c.is_zero()) zeros = zeros < 0 ? c.trailing_zeros() : std::min(zeros, c.trailing_zeros());
    }
    if (zeros <= 0) return;
    for (Integer& c : c_) c = c >> zeros;
}

template <int degree_max>
PolynomialOf<degree_max> derivative(const PolynomialOf<degree_max>& p) {
    typename PolynomialOf<degree_max>::Coefficients c;
    for (int i = 1; i <= degree_max; ++i) c[static_cast<std::size_t>(i - 1)] = Integer(std::int64_t{i}) * p[i];
    return PolynomialOf<degree_max>(std::move(c));
}

template <int degree_max>
PolynomialOf<degree_max> gcd(PolynomialOf<degree_max> p, PolynomialOf<degree_max> q) {
    if (p.degree() < q.degree()) std::swap(p, q);
    while (!q.is_zero()) {
        const int d = q.degree();
        while (p.degree() >= d && !p.is_zero()) {
            // Replaces p by q[d] p - p[e] s^(e - d) q, in which the leading terms cancel.
            const int e = p.degree();
            typename PolynomialOf<degree_max>::Coefficients rest;
            for (int i = 0; i < e; ++i) {
                Integer& c = rest[static_cast<std::size_t>(i)];
                c = p[i] * q[d];
                if (i >= e - d) c = c - q[i - (e - d)] * p[e];
            }
            p = PolynomialOf<degree_max>(std::move(rest));
        }
        p.drop_zeros();
        std::swap(p, q);
    }
    return p;
}

template <int degree_max>
PolynomialOf<degree_max> quotient(PolynomialOf<degree_max> p, const PolynomialOf<degree_max>& divisor) {
    const int d = divisor.degree();
    ECODS_ASSERT(d >= 0);
    typename PolynomialOf<degree_max>::Coefficients result, rest;
    for (int e = p.degree(); e >= d; --e) {
        // Multiplies all coefficients by the divisor's leading coefficient, so that the quotient's next coefficient is
        // an integer.
        for (Integer& c : result) c = c * divisor[d];
        result[static_cast<std::size_t>(e - d)] = p[e];
        for (int i = 0; i < e; ++i) {
            Integer& c = rest[static_cast<std::size_t>(i)];
            c = p[i] * divisor[d];
            if (i >= e - d) c = c - divisor[i - (e - d)] * p[e];
        }
        rest[static_cast<std::size_t>(e)] = {};
        p = PolynomialOf<degree_max>(rest);
    }
    ECODS_ASSERT(p.is_zero());
    PolynomialOf<degree_max> whole(std::move(result));
    whole.drop_zeros();
    return whole;
}

namespace {

// Arithmetic modulo a prime uses the prime 2^61 - 1.
constexpr int prime_bits = 61;
constexpr std::uint64_t prime = (std::uint64_t{1} << prime_bits) - 1;

constexpr std::uint64_t reduced(std::uint64_t x) noexcept {
    return x >= prime ? x - prime : x;
}
constexpr std::uint64_t product_of(std::uint64_t x, std::uint64_t y) noexcept {
    const Uint128 product = Uint128{x} * y;
    const auto low = static_cast<std::uint64_t>(product) & prime;
    return reduced(low + static_cast<std::uint64_t>(product >> prime_bits));
}
std::uint64_t reduced(const Integer& x) noexcept {
    std::uint64_t sum = 0;  // 2^64 is 2^3 modulo the prime
    for (std::size_t i = x.limbs().size(); i-- > 0;) {
        const std::uint64_t limb = x.limbs()[i];
        sum = reduced(product_of(sum, 8) + reduced(reduced(limb & prime) + (limb >> prime_bits)));
    }
    return x.sign() < 0 && sum != 0 ? prime - sum : sum;
}

}  // namespace

// Returns true if the greatest common divisor modulo the prime is a constant; the polynomials then have no common root.
// Proof: let h divide both polynomials, with integer coefficients that have no common divisor. Unless the prime divides
// the leading coefficients of both polynomials, it does not divide the leading coefficient of h. Then h has the same
// degree modulo the prime, and divides both polynomials there; so h is a constant, too.
template <int degree_max>
bool are_coprime(const PolynomialOf<degree_max>& p, const PolynomialOf<degree_max>& q) noexcept {
    using Residues = std::array<std::uint64_t, degree_max + 1>;
    Residues x{}, y{};
    int d = p.degree(), e = q.degree();
    if (d < 0 || e < 0) return false;
    for (int i = 0; i <= d; ++i) x[static_cast<std::size_t>(i)] = reduced(p[i]);
    for (int i = 0; i <= e; ++i) y[static_cast<std::size_t>(i)] = reduced(q[i]);
    if (x[static_cast<std::size_t>(d)] == 0 && y[static_cast<std::size_t>(e)] == 0) return false;
    const auto degree_of = [](const Residues& r) {
        int degree = degree_max;
        while (degree >= 0 && r[static_cast<std::size_t>(degree)] == 0) --degree;
        return degree;
    };
    for (d = degree_of(x), e = degree_of(y); e >= 0; d = degree_of(x), e = degree_of(y)) {
        if (d < e) {
            std::swap(x, y);
            continue;
        }
        if (e == 0) return true;
        const std::uint64_t lead = y[static_cast<std::size_t>(e)], minus_top = prime - x[static_cast<std::size_t>(d)];
        for (int i = 0; i <= d; ++i) {
            const auto at = static_cast<std::size_t>(i);
            x[at] = product_of(x[at], lead);
            if (i >= d - e) x[at] = reduced(x[at] + product_of(y[static_cast<std::size_t>(i - (d - e))], minus_top));
        }
        if (degree_of(x) < 0) return false;  // y divides x
    }
    return false;
}

template class PolynomialOf<3>;
template class PolynomialOf<5>;
template Polynomial derivative(const Polynomial&);
template Quintic derivative(const Quintic&);
template Polynomial gcd(Polynomial, Polynomial);
template Quintic gcd(Quintic, Quintic);
template Polynomial quotient(Polynomial, const Polynomial&);
template Quintic quotient(Quintic, const Quintic&);
template bool are_coprime(const Polynomial&, const Polynomial&) noexcept;
template bool are_coprime(const Quintic&, const Quintic&) noexcept;

}  // namespace ecods::exact
