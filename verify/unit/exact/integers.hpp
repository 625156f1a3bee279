// Integers and polynomials for tests, and their values by GMP.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "exact/number/polynomial.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::testing {

inline mpz_class mpz_of(const Integer& x) {
    mpz_class result;
    const NaturalSpan limbs = x.limbs();
    mpz_import(result.get_mpz_t(), limbs.size(), -1, sizeof(std::uint64_t), 0, 0, limbs.data());
    return x.sign() < 0 ? mpz_class(-result) : result;
}

inline mpz_class mpz_of(Int128 x) {
    return mpz_of(Integer(x));
}

inline mpq_class times_power(const mpq_class& x, long exponent) {
    if (exponent >= 0) return x << static_cast<unsigned long>(exponent);
    return x >> static_cast<unsigned long>(-exponent);
}

inline Integer integer_of(const mpz_class& x) {
    Integer result;
    const mpz_class size = abs(x);
    for (std::size_t i = mpz_size(size.get_mpz_t()); i-- > 0;) {
        const std::uint64_t limb = mpz_getlimbn(size.get_mpz_t(), static_cast<mp_size_t>(i));
        result = (result << 64) + Integer(static_cast<Int128>(limb));
    }
    return sgn(x) < 0 ? -result : result;
}

// Of at most so many bits, with runs of ones and zeros.
inline mpz_class random_mpz(scenes::Random& random, std::uint32_t bits) {
    mpz_class x = 0;
    for (std::uint32_t done = 0; done < bits;) {
        const std::uint32_t run = std::min(bits - done, 1 + random.below(random.below(4) == 0 ? 100 : 8));
        x <<= run;
        const std::uint32_t kind = random.below(3);
        if (kind == 0) x += (mpz_class(1) << run) - 1;
        if (kind == 1) x += random.below(2);
        done += run;
    }
    return random.below(2) == 0 ? x : mpz_class(-x);
}

inline mpq_class value_at(const Polynomial& p, const mpq_class& s) {
    mpq_class value = 0;
    for (int i = Polynomial::degree_max; i >= 0; --i) value = value * s + mpz_of(p[i]);
    return value;
}

// From the constant on.
inline Polynomial polynomial_of(const std::vector<mpz_class>& coefficients) {
    Polynomial::Coefficients c;
    for (std::size_t i = 0; i < coefficients.size(); ++i) c[i] = integer_of(coefficients[i]);
    return Polynomial(c);
}

}  // namespace ecods::exact::testing
