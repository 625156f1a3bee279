// Roots of polynomials of degree three at most: how many, in which order, how they are rounded, and the signs of other
// polynomials there, beside rational arithmetic; double roots, roots at the ends, at doubles, half-way between doubles
// and next to those, and too small for a double.

#include <gtest/gtest.h>

#include <cmath>

#include "base/next.hpp"
#include "exact/number/root.hpp"
#include "integers.hpp"

namespace ecods::exact::root_test {
namespace {

using testing::polynomial_of;
using testing::random_mpz;
using testing::value_at;

using Roots = std::vector<mpq_class>;

// factor times the product of (den s - num).
Polynomial product_of(const Roots& roots, const mpz_class& factor = 1) {
    std::vector<mpz_class> c{factor};
    for (const mpq_class& root : roots) {
        std::vector<mpz_class> next(c.size() + 1);
        for (std::size_t i = 0; i < c.size(); ++i) {
            next[i] -= c[i] * root.get_num();
            next[i + 1] += c[i] * root.get_den();
        }
        c = next;
    }
    return polynomial_of(c);
}

mpq_class power_of_two(int exponent) {
    return exponent >= 0 ? mpq_class(mpz_class(1) << exponent) : mpq_class(1, mpz_class(1) << -exponent);
}

// The nearest double to a number of the interval, in rationals.
double nearest(const mpq_class& x) {
    const double least = std::bit_cast<double>(std::uint64_t{1});
    double d = std::max(x.get_d(), least);  // towards zero
    // GMP's conversion does not promise subnormals.
    while (mpq_class(d) > x && d > least) d = next_down(d);
    while (mpq_class(next_up(d)) <= x) d = next_up(d);
    const mpq_class below = abs(x - mpq_class(d)), above = abs(mpq_class(next_up(d)) - x);
    if (above < below || (above == below && (std::bit_cast<std::uint64_t>(d) & 1) != 0)) d = next_up(d);
    return d;
}

void check_roots(const Roots& all, const mpz_class& factor = 1) {
    Roots expected;
    for (const mpq_class& root : all) {
        if (root > 0 && root <= 1) expected.push_back(root);
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::vector<Root> roots = roots_in_unit_interval(product_of(all, factor));
    ASSERT_EQ(roots.size(), expected.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        Root copy = roots[i];
        ASSERT_EQ(copy.round(), nearest(expected[i])) << expected[i];
        for (std::size_t j = 0; j < roots.size(); ++j) {
            ASSERT_EQ(compare(roots[i], roots[j]), i < j ? -1 : i > j) << expected[i] << ' ' << expected[j];
        }
        ASSERT_EQ(roots[i].sign_of(product_of(all)), 0);
        ASSERT_EQ(roots[i].sign_of(product_of({expected[i]})), 0);
        const mpq_class other = expected[i] + mpq_class(1, 1000003);
        ASSERT_EQ(roots[i].sign_of(product_of({other, expected[i]})), 0);
        ASSERT_EQ(roots[i].sign_of(product_of({other})), -1);
        ASSERT_EQ(roots[i].sign_of(product_of({other, other})), 1);
    }
}

TEST(Root, OfLatticePolynomials) {
    std::vector<mpq_class> numbers;
    for (int num = -2; num <= 14; ++num) numbers.emplace_back(num, 12);
    for (mpq_class& x : numbers) x.canonicalize();
    for (const mpz_class& factor : {mpz_class(1), mpz_class(-6), mpz_class(mpz_class(-5) << 200)}) {
        for (const mpq_class& x : numbers) {
            check_roots({x}, factor);
            for (const mpq_class& y : numbers) {
                check_roots({x, y}, factor);
                for (const mpq_class& z : numbers) check_roots({x, y, z}, factor);
            }
        }
    }
}

TEST(Root, ZeroAndConstantsHaveNone) {
    EXPECT_TRUE(roots_in_unit_interval({}).empty());
    EXPECT_TRUE(roots_in_unit_interval(polynomial_of({5})).empty());
    EXPECT_TRUE(roots_in_unit_interval(polynomial_of({0, 0, 3})).empty());
    EXPECT_TRUE(roots_in_unit_interval(polynomial_of({1, 0, 1})).empty());
}

// At doubles, half-way between two, and next to both by less than any double knows.
TEST(Root, IsRoundedOnce) {
    for (const double d : {0x1p-1074, 0x1p-1073, 0x3p-1074, 0x1p-1022, 0x1.8p-1022, 0x1p-60, 0.1, 0.5,
                           0x1.fffffffffffffp-1, 1 / 3.0, next_down(0.25), 0.25}) {
        const mpq_class at(d), half = (mpq_class(d) + mpq_class(next_up(d))) / 2;
        for (const mpq_class& middle : {at, half}) {
            for (const int bits : {0, -1080, -1200, -3000}) {
                for (const int side : {-1, 1}) {
                    const mpq_class x = bits == 0 ? middle : mpq_class(middle + side * power_of_two(bits));
                    if (x <= 0 || x > 1) continue;
                    check_roots({x});
                    check_roots({x, 5, -3});
                    check_roots({x, x, 7});
                }
            }
        }
    }
    check_roots({power_of_two(-1075)});
    check_roots({power_of_two(-5000), mpq_class(1, 3)});
    check_roots({mpq_class(1, mpz_class(3) << 4000)});
}

// Roots of very different sizes, of which some are near to each other: what is between them is passed in one step.
TEST(Root, FarApart) {
    std::vector<mpq_class> sizes{mpq_class(1, 3), mpq_class(-5, 7), 3 * power_of_two(70)};
    for (const int bits : {-3, -4, -40, -1700, -1701, -5000}) {
        sizes.push_back(power_of_two(bits));
        sizes.push_back(-power_of_two(bits));
        sizes.push_back(power_of_two(bits) + power_of_two(bits - 60));
    }
    for (const mpq_class& x : sizes) {
        for (const mpq_class& y : sizes) {
            for (const mpq_class& z : sizes) {
                if (x <= y && y <= z) check_roots({x, y, z});
            }
        }
    }
}

// Two roots that differ by very little are told apart, and the sign between them is right.
TEST(Root, NeighboursAreOrdered) {
    for (const int bits : {-50, -200, -2000}) {
        const mpq_class x(1, 3), y = x + power_of_two(bits);
        check_roots({x, y});
        check_roots({x, y, 1});
        std::vector<Root> first = roots_in_unit_interval(product_of({x}));
        std::vector<Root> second = roots_in_unit_interval(product_of({y, -1}));
        EXPECT_EQ(compare(first[0], second[0]), -1);
        EXPECT_EQ(compare(second[0], first[0]), 1);
        EXPECT_EQ(first[0].sign_of(product_of({y})), -1);
        EXPECT_EQ(second[0].sign_of(product_of({x})), 1);
    }
}

// Irrational ones, by the signs of their polynomial.
TEST(Root, OfRandomPolynomials) {
    scenes::Random random(2);
    int count = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::uint32_t width = 1 + random.below(round % 3 == 0 ? 6 : 500);
        std::vector<mpz_class> c;
        for (std::uint32_t i = 0; i <= 1 + random.below(3); ++i) c.push_back(random_mpz(random, width));
        const Polynomial p = polynomial_of(c);
        std::vector<Root> roots = roots_in_unit_interval(p);
        std::size_t found = 0;
        for (Root& root : roots) {
            Root copy = root;
            const double d = copy.round();
            const mpq_class low = (mpq_class(d) + mpq_class(next_down(d))) / 2,
                            high = (mpq_class(d) + mpq_class(next_up(d))) / 2;
            const int below = sgn(value_at(p, low)), above = sgn(value_at(p, high));
            if (below * above <= 0) ++found;
            ASSERT_EQ(root.sign_of(p), 0);
            const int side = root.sign_of(product_of({mpq_class(d)}));
            // Nothing but the root is between the number and its rounding, unless several are so close.
            if (roots.size() == 1 && side != 0 && below * above < 0) {
                ASSERT_EQ(sgn(value_at(p, mpq_class(d))), side > 0 ? below : above);
            }
            ++count;
        }
        // Double ones do not change signs.
        ASSERT_GE(found + 1, roots.size());
        // Signs on a grid change no more often than there are roots, and as often but for an even number in between.
        int changes = 0, last = 0;
        for (int i = 0; i <= 64; ++i) {
            const int sign = sgn(value_at(p, mpq_class(i, 64)));
            if (sign == 0) continue;
            changes += last != 0 && sign != last;
            last = sign;
        }
        ASSERT_LE(changes, static_cast<int>(roots.size()));
    }
    EXPECT_GT(count, 700);
}

// The roots of one polynomial beside those of its multiples and of others.
TEST(Root, EqualRootsOfDifferentPolynomials) {
    const Polynomial p = polynomial_of({-1, 0, 3});       // 1 / sqrt 3
    const Polynomial q = polynomial_of({-1, -1, 3, 3});   // times s + 1
    const Polynomial r = polynomial_of({1, -7, -3, 21});  // times 7 s - 1
    std::vector<Root> of_p = roots_in_unit_interval(p), of_q = roots_in_unit_interval(q),
                      of_r = roots_in_unit_interval(r);
    ASSERT_EQ(of_p.size(), 1u);
    ASSERT_EQ(of_q.size(), 1u);
    ASSERT_EQ(of_r.size(), 2u);
    EXPECT_EQ(compare(of_p[0], of_q[0]), 0);
    EXPECT_EQ(compare(of_q[0], of_r[1]), 0);
    EXPECT_EQ(compare(of_p[0], of_r[0]), 1);
    EXPECT_EQ(of_p[0].sign_of(q), 0);
    EXPECT_EQ(of_r[1].sign_of(q), 0);
    EXPECT_EQ(of_p[0].round(), nearest(mpq_class(std::sqrt(1 / 3.0))));
}

// Above or below a double that it rounds to, by however little.
TEST(Root, IsAboveADouble) {
    for (const double d : {0x1p-1074, 0x3p-1074, 0x1p-60, 0.1, 1 / 3.0, 0.5, next_down(1)}) {
        for (const int bits : {-60, -1080, -3000}) {
            const mpq_class above = mpq_class(d) + power_of_two(bits) * mpq_class(d),
                            below = mpq_class(d) - power_of_two(bits) * mpq_class(d);
            EXPECT_TRUE(roots_in_unit_interval(product_of({above})).at(0).is_above(d));
            EXPECT_FALSE(roots_in_unit_interval(product_of({mpq_class(d)})).at(0).is_above(d));
            EXPECT_FALSE(roots_in_unit_interval(product_of({below})).at(0).is_above(d));
        }
    }
}

// In each interval of a grid, the roots of all of them; unless two are in one.
TEST(Root, InShortIntervals) {
    std::vector<mpq_class> numbers;
    for (int num = 0; num <= 12; ++num) numbers.emplace_back(num, 12);
    for (mpq_class& x : numbers) x.canonicalize();
    for (const mpq_class& x : numbers) {
        for (const mpq_class& y : numbers) {
            const Polynomial p = product_of({x, y, mpq_class(7, 5)});
            std::size_t count = 0;
            bool is_parted = true;
            for (std::int64_t m = 0; m < 16; m += 2) {
                const auto roots = simple_roots_in(p, {Integer(m), 4}, 2);
                is_parted = is_parted && roots;
                if (roots) count += roots->size();
            }
            if (is_parted) {
                EXPECT_EQ(count, roots_in_unit_interval(p).size());
            } else {
                EXPECT_LT(abs(x - y), mpq_class(1, 16));
            }
        }
    }
}

}  // namespace
}  // namespace ecods::exact::root_test
