// Parameters of lines and the points there, rounded once, beside rationals, in every floating-point environment.
#include "exact/measure/round/fraction.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "integers.hpp"
#include "measured_pairs.hpp"
#include "oracle/nearest.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::fraction_test {
namespace {

Natural<fraction_limbs> natural_of(const mpz_class& x) {
    std::vector<std::uint64_t> limbs(mpz_size(x.get_mpz_t()));
    for (std::size_t i = 0; i < limbs.size(); ++i) limbs[i] = mpz_getlimbn(x.get_mpz_t(), static_cast<mp_size_t>(i));
    Natural<fraction_limbs> result;
    result.assign(limbs);
    return result;
}

Fraction fraction(const mpz_class& num, const mpz_class& den) {
    Fraction result;
    result.num = natural_of(num);
    result.den = natural_of(den);
    return result;
}

void check_on_line(const Vec3& a, const Vec3& b, const mpz_class& num, const mpz_class& den) {
    mpq_class s(num, den);
    s.canonicalize();
    const Fraction at = fraction(num, den);
    for (const bool is_direction : {false, true}) {
        Vec3 expected;
        for (int k = 0; k < 3; ++k) {
            const mpq_class from(a[k]), to(b[k]);
            expected[k] = nearest(from + (is_direction ? to : mpq_class(to - from)) * s);
        }
        const double parameter = sgn(num) == 0 ? 0 : std::max(nearest(s), 0x1p-1074);
        for (const int environment : environments) {
            const RoundedOnLine rounded =
                in_environment(environment, [&] { return round_on_line(a, b, is_direction, at.ref()); });
            ASSERT_EQ(bits(rounded.parameter), bits(parameter)) << num << " / " << den;
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(bits(rounded.point[k]), bits(expected[k]))
                    << num << " / " << den << " from " << a[k] << " to " << b[k];
            }
        }
    }
}

Vec3 any_point(Random& random, int range) {
    const auto any = [&] {
        if (random.below(8) == 0) return 0.0;
        return std::ldexp(random.uniform(-1, 1),
                          static_cast<int>(random.below(static_cast<std::uint32_t>(range))) - range / 2);
    };
    const double x = any(), y = any();
    return {x, y, any()};
}

TEST(RoundOnLine, AsRationals) {
    Random random(1);
    for (int i = 0; i < 4000; ++i) {
        const mpz_class den = abs(testing::random_mpz(random, 1 + random.below(500))) + 1;
        mpz_class num = abs(testing::random_mpz(random, 1 + random.below(500)));
        if (i % 2 == 0) num %= den + 1;
        const int range = i % 4 == 3 ? 2000 : 8;
        ASSERT_NO_FATAL_FAILURE(check_on_line(any_point(random, range), any_point(random, range), num, den)) << i;
    }
}

// Coordinates half-way between two doubles, and beside that by less than the leading digits of the parameter show.
TEST(RoundOnLine, HalfWayAndBesideIt) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        Vec3 a = any_point(random, 4), b = a;
        for (int k = 0; k < 3; ++k) b[k] = std::nextafter(a[k], k == i % 3 ? 10 : -10);
        for (const int width : {1, 64, 126, 127, 128, 129, 200, 300}) {
            const mpz_class half = mpz_class(1) << width;
            for (const int beside : {-1, 0, 1}) {
                ASSERT_NO_FATAL_FAILURE(check_on_line(a, b, half + beside, 2 * half)) << i << ", " << width;
                ASSERT_NO_FATAL_FAILURE(check_on_line(-a, a, half + beside, 2 * half)) << i << ", " << width;
            }
        }
    }
}

TEST(RoundOnLine, AtTheEndsOfTheRange) {
    const double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
    const Vec3 a(most, least, -most), b(-most, -least, most);
    const mpz_class large = mpz_class(1) << 1100;
    for (const mpz_class& num : {mpz_class(0), mpz_class(1), mpz_class(3), large, mpz_class(large + 1)}) {
        for (const mpz_class& den : {mpz_class(1), mpz_class(3), mpz_class(4), large, mpz_class(3 * large - 1)}) {
            ASSERT_NO_FATAL_FAILURE(check_on_line(a, b, num, den));
            ASSERT_NO_FATAL_FAILURE(check_on_line(b, Vec3(1, 0x1p-1022, 3 * least), num, den));
        }
    }
}

TEST(Fractions, CompareAsRationals) {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const std::uint32_t width = 1 + random.below(i % 3 == 0 ? 700 : 140);
        const auto any = [&] { return mpz_class(abs(testing::random_mpz(random, width)) + 1); };
        const mpz_class den_a = any(), factor = any();
        mpz_class num_a = any(), num_b = any(), den_b = random.below(3) == 0 ? den_a : any();
        if (random.below(3) == 0) {
            num_b = num_a * factor + (random.below(3) - mpz_class(1));
            den_b = den_a * factor;
        }
        const Fraction a = fraction(num_a, den_a), b = fraction(num_b, den_b);
        ASSERT_EQ(compare(a.ref(), b.ref()), sgn(num_a * den_b - num_b * den_a)) << i;
        ASSERT_EQ(compare(b.ref(), a.ref()), sgn(num_b * den_a - num_a * den_b)) << i;
        mpq_class other(num_b, den_b);
        other.canonicalize();
        const double d = nearest(other);
        if (!std::isfinite(d)) continue;
        mpq_class q(num_a, den_a);
        q.canonicalize();
        ASSERT_EQ(compare(a.ref(), d), sgn(mpq_class(q - mpq_class(d)))) << i;
    }
}

}  // namespace
}  // namespace ecods::exact::fraction_test
