// Integers of any length beside GMP's: sums, products, shifts and comparisons, with carries, in place and on the heap.

#include <gtest/gtest.h>

#include "exact/number/integer.hpp"
#include "integers.hpp"

namespace ecods::exact::integer_test {
namespace {

using testing::integer_of;
using testing::mpz_of;
using testing::random_mpz;

TEST(Integer, AgreesWithGmp) {
    scenes::Random random(1);
    for (int round = 0; round < 20000; ++round) {
        const mpz_class a = random_mpz(random, random.below(round % 10 == 0 ? 3000 : 300));
        const mpz_class b = random_mpz(random, random.below(round % 7 == 0 ? 3000 : 300));
        const Integer x = integer_of(a), y = integer_of(b);
        ASSERT_EQ(mpz_of(x), a);
        ASSERT_EQ(mpz_of(x + y), a + b);
        ASSERT_EQ(mpz_of(x - y), a - b);
        ASSERT_EQ(mpz_of(x - (x - y)), b);
        ASSERT_EQ(mpz_of(x * y), a * b);
        ASSERT_EQ(mpz_of(-x), -a);
        ASSERT_EQ(x.sign(), sgn(a));
        ASSERT_EQ(compare(x, y), cmp(a, b) < 0 ? -1 : cmp(a, b) > 0);
        ASSERT_EQ(compare(x, integer_of(a)), 0);
        const int bits = static_cast<int>(random.below(400));
        ASSERT_EQ(mpz_of(x << bits), a << bits);
        // Towards zero, as GMP's division is.
        ASSERT_EQ(mpz_of(x >> bits), a / (mpz_class(1) << bits));
        if (a != 0) {
            ASSERT_EQ(x.bit_width(), static_cast<int>(mpz_sizeinbase(a.get_mpz_t(), 2)));
            ASSERT_EQ(x.trailing_zeros(), static_cast<int>(mpz_scan1(a.get_mpz_t(), 0)));
        }
    }
}

TEST(Integer, IsMadeOfEveryKindOfNumber) {
    EXPECT_EQ(mpz_of(Integer(std::int64_t{-5})), -5);
    EXPECT_EQ(mpz_of(Integer(std::numeric_limits<std::int64_t>::min())), -(mpz_class(1) << 63));
    EXPECT_EQ(mpz_of(Integer(Int128{1} << 100)), mpz_class(1) << 100);
    EXPECT_EQ(mpz_of(Integer(-(Int128{1} << 100))), -(mpz_class(1) << 100));
    EXPECT_EQ(mpz_of(Integer(Limbs<3>{~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}})), -1);
    EXPECT_EQ(mpz_of(Integer(Limbs<3>{0, 0, 1})), mpz_class(1) << 128);
}

TEST(Integer, MovesAndCopies) {
    for (const int bits : {5, 5000}) {
        Integer x = Integer(std::int64_t{-3}) << bits;
        const mpz_class value = mpz_of(x);
        Integer copy = x;
        EXPECT_EQ(mpz_of(copy), value);
        Integer moved = std::move(x);
        EXPECT_EQ(mpz_of(moved), value);
        x = copy;
        EXPECT_EQ(mpz_of(x), value);
        x = std::move(copy);
        EXPECT_EQ(mpz_of(x), value);
        x = Integer(std::int64_t{7});
        EXPECT_EQ(mpz_of(x), 7);
        EXPECT_EQ(mpz_of(moved), value);
    }
}

}  // namespace
}  // namespace ecods::exact::integer_test
