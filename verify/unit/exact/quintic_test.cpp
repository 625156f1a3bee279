// Roots of polynomials of degree five at most, as RootTest has them of degree three: rational and irrational ones of
// every multiplicity, beside rational arithmetic; common divisors, quotients and residues.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/next.hpp"
#include "exact/number/root.hpp"
#include "integers.hpp"

namespace ecods::exact::quintic_test {
namespace {

using testing::integer_of;
using testing::mpz_of;
using testing::random_mpz;

using Coefficients = std::vector<mpz_class>;  // from the constant on
using QuinticRoot = RootOf<Quintic>;

Coefficients product_of(const Coefficients& p, const Coefficients& q) {
    Coefficients product(p.size() + q.size() - 1);
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
    }
    return product;
}

Coefficients product_of(const std::vector<Coefficients>& factors) {
    Coefficients product{1};
    for (const Coefficients& factor : factors) product = product_of(product, factor);
    return product;
}

Quintic quintic_of(const Coefficients& coefficients) {
    Quintic::Coefficients c;
    for (std::size_t i = 0; i < coefficients.size(); ++i) c.at(i) = integer_of(coefficients[i]);
    return Quintic(c);
}

mpq_class value_of(const Quintic& p, const mpq_class& s) {
    mpq_class value = 0;
    for (int i = Quintic::degree_max; i >= 0; --i) value = value * s + mpz_of(p[i]);
    return value;
}

Coefficients with_root(const mpq_class& root) {
    return {-root.get_num(), root.get_den()};
}

// Between 0 and 1, 0 excluded and 1 included, each once.
std::vector<mpq_class> expected_roots(std::vector<mpq_class> all) {
    std::erase_if(all, [](const mpq_class& root) { return root <= 0 || root > 1; });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

bool rounds_to(const mpq_class& x, double d) {
    const mpq_class below = (mpq_class(d) + mpq_class(next_down(d))) / 2,
                    above = (mpq_class(d) + mpq_class(next_up(d))) / 2;
    return below <= x && x <= above;
}

void check_roots(const std::vector<mpq_class>& all, const Coefficients& more = {1}) {
    const std::vector<mpq_class> expected = expected_roots(all);
    std::vector<Coefficients> factors{more};
    for (const mpq_class& root : all) factors.push_back(with_root(root));
    const Quintic p = quintic_of(product_of(factors));
    std::vector<QuinticRoot> roots = roots_in_unit_interval(p);
    ASSERT_EQ(roots.size(), expected.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        QuinticRoot copy = roots[i];
        ASSERT_TRUE(rounds_to(expected[i], copy.round())) << expected[i];
        for (std::size_t j = 0; j < roots.size(); ++j) {
            ASSERT_EQ(compare(roots[i], roots[j]), i < j ? -1 : i > j) << expected[i] << ' ' << expected[j];
        }
        ASSERT_EQ(roots[i].sign_of(p), 0);
        ASSERT_EQ(roots[i].sign_of(quintic_of(with_root(expected[i]))), 0);
        const mpq_class other = expected[i] + mpq_class(1, 1000003);
        ASSERT_EQ(roots[i].sign_of(quintic_of(with_root(other))), -1);
        const Coefficients four = product_of({with_root(other), with_root(other), {1, 0, 1}});
        ASSERT_EQ(roots[i].sign_of(quintic_of(four)), 1);
        ASSERT_EQ(roots[i].sign_of(quintic_of(product_of(four, with_root(expected[i])))), 0);
    }
}

// All multisets of five or fewer of these.
TEST(Quintic, OfAllRationalRoots) {
    const std::vector<mpq_class> numbers{0, mpq_class(1, 12), mpq_class(1, 2), mpq_class(7, 12), 1, mpq_class(-1, 3)};
    const std::size_t n = numbers.size();
    int count = 0;
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a; b < n; ++b) {
            for (std::size_t c = b; c < n; ++c) {
                check_roots({numbers[a], numbers[b], numbers[c]}, {1, 0, 1});
                for (std::size_t d = c; d < n; ++d) {
                    check_roots({numbers[a], numbers[b], numbers[c], numbers[d]}, {-6});
                    for (std::size_t e = d; e < n; ++e) {
                        check_roots({numbers[a], numbers[b], numbers[c], numbers[d], numbers[e]},
                                    {mpz_class(-5) << 200});
                        ++count;
                    }
                }
            }
        }
    }
    EXPECT_EQ(count, 252);
}

TEST(Quintic, RootsThatAreNear) {
    const mpq_class x(1, 3);
    for (const unsigned bits : {20U, 60U, 300U}) {
        const mpq_class y = x + mpq_class(1, mpz_class(1) << bits);
        check_roots({x, y});
        check_roots({x, x, y});
        check_roots({x, x, y, y, y});
        check_roots({x, x, y, y}, {-1, 3});
        check_roots({x, y, y, y, mpq_class(1, 2)});
    }
}

// Of polynomials with irrational roots, some of them multiple, by factors.
TEST(Quintic, IrrationalRoots) {
    const Coefficients third{-1, 0, 3}, half{-1, 0, 2}, none{2, 0, 1}, cube{-1, 0, 0, 3};  // of 1 / 3, 1 / 2
    const auto roots_of = [](const std::vector<Coefficients>& factors) {
        return roots_in_unit_interval(quintic_of(product_of(factors)));
    };
    QuinticRoot r3 = roots_of({third}).at(0), r2 = roots_of({half}).at(0), c3 = roots_of({cube}).at(0);
    EXPECT_EQ(compare(r3, r2), -1);
    EXPECT_EQ(compare(r3, c3), -1);
    EXPECT_NEAR(r3.round(), std::sqrt(1 / 3.0), 0x1p-53);
    EXPECT_NEAR(c3.round(), std::cbrt(1 / 3.0), 0x1p-53);
    const auto expect = [](std::vector<QuinticRoot> found, std::vector<QuinticRoot*> expected) {
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(compare(found[i], *expected[i]), 0) << i;
    };
    QuinticRoot one(BinaryFraction{Integer(std::int64_t{1}), 0}), middle(BinaryFraction{Integer(std::int64_t{1}), 1});
    expect(roots_of({third, third}), {&r3});
    expect(roots_of({third, half}), {&r3, &r2});
    expect(roots_of({third, third, {-1, 1}}), {&r3, &one});
    expect(roots_of({half, half, {-1, 2}}), {&middle, &r2});
    expect(roots_of({third, half, {-1, 2}}), {&middle, &r3, &r2});
    expect(roots_of({none, none, {-1, 2}}), {&middle});
    expect(roots_of({third, {-1, 2}, {-1, 2}}), {&middle, &r3});
    expect(roots_of({third, {-1, 2}, {-1, 2}, {-1, 2}}), {&middle, &r3});
    expect(roots_of({cube, {-1, 2}, {-1, 2}}), {&middle, &c3});
    expect(roots_of({cube, third}), {&r3, &c3});
    EXPECT_EQ(r3.sign_of(quintic_of(product_of({third, cube}))), 0);
    EXPECT_EQ(r3.sign_of(quintic_of(product_of({half, cube}))), 1);
    EXPECT_EQ(c3.sign_of(quintic_of(product_of({third, cube}))), 0);
}

// Signs half-way to the neighbours of the rounded root.
TEST(Quintic, OfRandomPolynomials) {
    scenes::Random random(5);
    int count = 0;
    for (int round = 0; round < 1000; ++round) {
        const std::uint32_t width = 1 + random.below(round % 3 == 0 ? 6 : 900);
        Coefficients c;
        for (std::uint32_t i = 0; i <= 2 + random.below(4); ++i) c.push_back(random_mpz(random, width));
        const Quintic p = quintic_of(c);
        std::vector<QuinticRoot> roots = roots_in_unit_interval(p);
        for (QuinticRoot& root : roots) {
            QuinticRoot copy = root;
            const double d = copy.round();
            ASSERT_EQ(root.sign_of(p), 0);
            // Another polynomial is evaluated at a near fraction: both agree unless its own root is between.
            const mpq_class low = (mpq_class(d) + mpq_class(next_down(d))) / 2,
                            high = (mpq_class(d) + mpq_class(next_up(d))) / 2;
            if (sgn(value_of(p, low)) * sgn(value_of(p, high)) < 0) ++count;
            const Quintic g = quintic_of({random_mpz(random, 9), random_mpz(random, 9), random_mpz(random, 9),
                                          random_mpz(random, 9), random_mpz(random, 9), 1});
            const int below = sgn(value_of(g, low)), above = sgn(value_of(g, high));
            if (below == above && below != 0) {
                ASSERT_EQ(root.sign_of(g), below);
            }
        }
        int changes = 0, last = 0;
        for (int i = 0; i <= 64; ++i) {
            const int sign = sgn(value_of(p, mpq_class(i, 64)));
            if (sign == 0) continue;
            changes += last != 0 && sign != last;
            last = sign;
        }
        ASSERT_LE(changes, static_cast<int>(roots.size()));
    }
    EXPECT_GT(count, 300);
}

TEST(Quintic, BernsteinCoefficients) {
    scenes::Random random(6);
    const auto choose = [](int n, int k) {
        mpq_class result = 1;
        for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
        return result;
    };
    for (int degree = 0; degree <= 5; ++degree) {
        Coefficients c;
        for (int i = 0; i <= degree; ++i) c.push_back(random_mpz(random, 40));
        c.back() += mpz_class(1) << 50;
        const Quintic::Coefficients found = quintic_of(c).on_unit_interval();
        for (int j = 0; j <= degree; ++j) {
            mpq_class expected = 0;
            for (int i = 0; i <= j; ++i) {
                expected += c[static_cast<std::size_t>(i)] * choose(j, i) / choose(degree, i);
            }
            EXPECT_EQ(mpz_of(found[static_cast<std::size_t>(j)]), expected * choose(degree, j));
        }
    }
}

// Common roots are found, and residues never deny them; what has none is recognized.
TEST(Quintic, CommonDivisors) {
    scenes::Random random(7);
    for (int round = 0; round < 300; ++round) {
        const std::uint32_t width = 1 + random.below(300);
        const auto any = [&](std::uint32_t degree) {
            Coefficients c;
            for (std::uint32_t i = 0; i <= degree; ++i) c.push_back(random_mpz(random, width));
            if (c.back() == 0) c.back() = 1;
            return c;
        };
        const std::uint32_t common = 1 + random.below(3);
        const Coefficients d = any(common);
        const Quintic p = quintic_of(product_of(d, any(random.below(6 - common)))),
                      q = quintic_of(product_of(d, any(random.below(6 - common))));
        EXPECT_FALSE(are_coprime(p, q));
        const Quintic divisor = gcd(p, q);
        EXPECT_GE(divisor.degree(), static_cast<int>(common));
        // p = factor (p / divisor) divisor
        const Quintic product = quotient(p, divisor) * divisor;
        ASSERT_EQ(product.degree(), p.degree());
        for (int i = 0; i <= p.degree(); ++i) EXPECT_EQ(product[i] * p[p.degree()], p[i] * product[p.degree()]);
        const Quintic other = quintic_of(product_of({{-1, 2}, {-1, 0, 0, 3}}));
        EXPECT_TRUE(are_coprime(other, quintic_of(product_of({{1, 2}, {1, 0, 1}}))));
    }
    // A leading coefficient that the prime divides proves nothing.
    const mpz_class prime = (mpz_class(1) << 61) - 1;
    EXPECT_FALSE(
        are_coprime(quintic_of(product_of({{-1, prime}, {1, 1}})), quintic_of(product_of({{-1, prime}, {2, 1}}))));
    EXPECT_FALSE(are_coprime(quintic_of({-1, prime}), quintic_of({-1, prime})));
    EXPECT_FALSE(are_coprime(quintic_of({prime, 2 * prime}), quintic_of({1, 1})));
    EXPECT_FALSE(are_coprime(Quintic(), quintic_of({1, 1})));
}

}  // namespace
}  // namespace ecods::exact::quintic_test
