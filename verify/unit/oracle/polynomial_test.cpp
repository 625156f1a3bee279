// Roots of polynomials from 0 to 1, and signs at them.
#include "oracle/polynomial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle/linear_program.hpp"
#include "scenes/random.hpp"

namespace ecods::oracle::polynomial_test {
namespace {

Polynomial polynomial(std::initializer_list<int> coefficients) {
    std::vector<mpz_class> c;
    for (const int x : coefficients) c.emplace_back(x);
    return Polynomial(std::move(c));
}

// den x - num
Polynomial with_root(int num, int den) {
    return polynomial({-num, den});
}

std::vector<double> roots(const Polynomial& f) {
    std::vector<double> found;
    for (const Root& root : roots_to_one(f)) found.push_back(root.nearest());
    return found;
}

TEST(OraclePolynomial, RootsFromZeroToOne) {
    EXPECT_TRUE(roots(polynomial({})).empty());
    EXPECT_TRUE(roots(polynomial({7})).empty());
    EXPECT_TRUE(roots(polynomial({1, 0, 1})).empty());
    EXPECT_TRUE(roots(polynomial({-3, 1})).empty());
    EXPECT_EQ(roots(polynomial({0, 1})), (std::vector<double>{0}));
    EXPECT_EQ(roots(polynomial({-1, 1})), (std::vector<double>{1}));
    EXPECT_EQ(roots(polynomial({-1, 0, 2})), (std::vector<double>{0x1.6a09e667f3bcdp-1}));  // the root of 1 / 2
    EXPECT_EQ(roots(polynomial({0, -1, 0, 1})), (std::vector<double>{0, 1}));
    EXPECT_EQ(roots(with_root(1, 3) * with_root(1, 2) * with_root(2, 3)), (std::vector<double>{1.0 / 3, 0.5, 2.0 / 3}));
    EXPECT_EQ(roots(with_root(1, 3) * with_root(1, 3) * with_root(5, 7)), (std::vector<double>{1.0 / 3, 5.0 / 7}));
    EXPECT_EQ(roots(with_root(1, 3) * with_root(1, 3)), (std::vector<double>{1.0 / 3}));
}

TEST(OraclePolynomial, RandomRoots) {
    scenes::Random random(1);
    for (int i = 0; i < 3000; ++i) {
        Polynomial f(1 + static_cast<int>(random.below(3)));
        std::vector<double> expected;
        for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
            const int den = 1 + static_cast<int>(random.below(40)), num = static_cast<int>(random.below(60)) - 10;
            f = f * with_root(num, den);
            if (num >= 0 && num <= den) expected.push_back(double(num) / den);
        }
        std::ranges::sort(expected);
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        ASSERT_EQ(roots(f), expected) << i;
    }
}

TEST(OraclePolynomial, RootsAreCompared) {
    Root half_root = roots_to_one(polynomial({-1, 0, 2})).at(0);
    Root same = roots_to_one(polynomial({-1, 0, 2}) * with_root(9, 10)).at(0);
    Root other = roots_to_one(polynomial({-1, 0, 3})).at(0);
    EXPECT_EQ(half_root.compare(same), 0);
    EXPECT_EQ(same.compare(half_root), 0);
    EXPECT_GT(half_root.compare(other), 0);
    EXPECT_LT(other.compare(same), 0);
    EXPECT_GT(half_root.compare(mpq_class(0x1.6a09e667f3bccp-1)), 0);
    EXPECT_LT(half_root.compare(mpq_class(0x1.6a09e667f3bcdp-1)), 0);
    Root third = roots_to_one(with_root(1, 3)).at(0);
    EXPECT_EQ(third.compare(mpq_class(1, 3)), 0);
}

TEST(OraclePolynomial, SignsAtARoot) {
    Root root = roots_to_one(polynomial({-1, 0, 2})).at(0);
    EXPECT_EQ(root.sign_of(polynomial({})), 0);
    EXPECT_EQ(root.sign_of(polynomial({-5})), -1);
    EXPECT_EQ(root.sign_of(polynomial({0, 1}) * polynomial({-1, 0, 2})), 0);
    EXPECT_EQ(root.sign_of(polynomial({-1, 0, 2}) + Polynomial(1)), 1);
    EXPECT_EQ(root.sign_of(polynomial({-7071, 10000})), 1);
    EXPECT_EQ(root.sign_of(polynomial({-7072, 10000})), -1);
    // Smaller than any double's unit beside the root: 2 x^2 - 1 + 2^-300.
    EXPECT_EQ(root.sign_of(Polynomial({-(mpz_class(1) << 300) + 1, 0, mpz_class(1) << 301})), 1);
    EXPECT_EQ(root.sign_of(Polynomial({-(mpz_class(1) << 300) - 1, 0, mpz_class(1) << 301})), -1);
}

TEST(OraclePolynomial, RoundedOnce) {
    const auto rounded = [](const mpq_class& x) { return Root(x).nearest(); };
    const mpq_class unit = mpq_class(0x1p-53);
    EXPECT_EQ(rounded(mpq_class(0.5) + unit / 2), 0.5);  // half-way, to even
    EXPECT_EQ(rounded(mpq_class(0.5) + 3 * unit / 2), 0.5 + 0x1p-52);
    EXPECT_EQ(rounded(mpq_class(0.5) + unit / 2 + mpq_class(0x1p-200)), 0.5 + 0x1p-53);
    EXPECT_EQ(rounded(1 - unit / 4), 1);
    EXPECT_EQ(rounded(mpq_class(1, mpz_class(1) << 1100)), 0x1p-1074);
    EXPECT_EQ(rounded(0), 0);
    EXPECT_EQ(roots_to_one(Polynomial({-1, mpz_class(1) << 1200})).at(0).nearest(), 0x1p-1074);
    // Roots of 2^-2n and of 2^(1 - 2n), which are and are no powers of two.
    for (const int n : {1, 9, 10, 17, 100, 333, 537, 2000}) {
        const mpz_class square = mpz_class(1) << 2 * n;
        EXPECT_EQ(roots_to_one(Polynomial({-1, 0, square})).at(0).nearest(), std::max(std::ldexp(1, -n), 0x1p-1074));
        EXPECT_EQ(roots_to_one(Polynomial({-2, 0, square})).at(0).nearest(),
                  std::max(std::ldexp(0x1.6a09e667f3bcdp+0, -n), 0x1p-1074));
    }
}

TEST(OraclePolynomial, LinearPrograms) {
    // x + y = 3, x - z = 1: the least x is 1. x = y = -1 has no solution. Twice the same equation is one.
    EXPECT_EQ(least_first_variable({{1, 1, 0, 3}, {1, 0, -1, 1}}), mpq_class(1));
    EXPECT_EQ(least_first_variable({{1, 1, 0, 3}, {2, 2, 0, 6}, {0, 2, 0, 3}}), mpq_class(3, 2));
    EXPECT_EQ(least_first_variable({{1, 1, -1}}), std::nullopt);
    EXPECT_EQ(least_first_variable({{-1, -1, -2}, {0, 1, 3}}), std::nullopt);
    EXPECT_EQ(least_first_variable({{1, -1, 0}, {1, 1, 0}}), mpq_class(0));
}

}  // namespace
}  // namespace ecods::oracle::polynomial_test
