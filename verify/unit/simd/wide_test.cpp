#include "simd/wide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "environment/instruction_sets.hpp"

#if ECODS_CAN_DISPATCH

namespace ecods {
namespace {

bool has_wide_registers() {
    const auto sets = environment::supported_instruction_sets();
    return std::find(sets.begin(), sets.end(), InstructionSet::avx512) != sets.end();
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

struct alignas(64) Eight {
    std::array<float, 8> numbers;
};
struct alignas(64) Sixteen {
    std::array<float, 16> numbers;
};

// Vectors stay inside of functions for the instruction set.
ECODS_BEGIN_WIDE
template <int first>
void spread(const Eight& x, Sixteen& all, Sixteen& two) {
    const wide::Floats v = wide::twice(x.numbers.data());
    _mm512_store_ps(all.numbers.data(), v);
    _mm512_store_ps(two.numbers.data(), wide::two_of<first>(v));
}
ECODS_END_REGION

template <int first>
void expect_spread(const Eight& x) {
    Sixteen all, two;
    spread<first>(x, all, two);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(all.numbers[i], x.numbers[i]);
        EXPECT_EQ(all.numbers[8 + i], x.numbers[i]);
        EXPECT_EQ(two.numbers[i], x.numbers[first]);
        EXPECT_EQ(two.numbers[8 + i], x.numbers[first + 1]);
    }
}

TEST(Wide, SpreadsEightNumbers) {
    if (!has_wide_registers()) GTEST_SKIP() << "no registers of sixteen floats";
    const Eight x{{1, 2, 3, 4, 5, 6, 7, 8}};
    expect_spread<0>(x);
    expect_spread<2>(x);
    expect_spread<4>(x);
    expect_spread<6>(x);
}

struct Compared {
    std::uint32_t not_above, not_below;
};
ECODS_BEGIN_WIDE
Compared compare(std::uint32_t lanes, const Sixteen& x, const Sixteen& y) {
    const wide::Floats a = _mm512_load_ps(x.numbers.data()), b = _mm512_load_ps(y.numbers.data());
    const auto mask = static_cast<wide::Mask>(lanes);
    return {wide::not_above(mask, a, b), wide::not_below(mask, a, b)};
}
ECODS_END_REGION

TEST(Wide, ComparesTheLanesOfAMask) {
    if (!has_wide_registers()) GTEST_SKIP() << "no registers of sixteen floats";
    const Sixteen x{{0, 0, 0, nan, 0, nan, infinity, -infinity, 0.0f, 1, 2, 3, 0, 0, 0, 0}},
        y{{0, 1, -1, 0, nan, nan, infinity, infinity, -0.0f, 3, 2, 1, 1, 1, -1, -1}};
    for (const std::uint32_t lanes : {0xffffu, 0u, 0x5555u, 0x8001u}) {
        Compared expected{};
        for (std::uint32_t i = 0; i < 16; ++i) {
            const std::uint32_t bit = lanes & 1u << i;
            if (!(x.numbers[i] > y.numbers[i])) expected.not_above |= bit;
            if (!(x.numbers[i] < y.numbers[i])) expected.not_below |= bit;
        }
        const Compared found = compare(lanes, x, y);
        EXPECT_EQ(found.not_above, expected.not_above);
        EXPECT_EQ(found.not_below, expected.not_below);
    }
}

ECODS_BEGIN_WIDE
std::uint32_t not_outside(const Eight& low, const Eight& high, float from, float to) {
    return wide::not_outside(_mm256_load_ps(low.numbers.data()), _mm256_load_ps(high.numbers.data()), from, to);
}
ECODS_END_REGION

TEST(Wide, FindsIntervalsThatReachAnother) {
    if (!has_wide_registers()) GTEST_SKIP() << "no registers of sixteen floats";
    const Eight low{{-3, -3, -3, 1, 2, 3, nan, -3}}, high{{-2, -1, 3, 3, 3, 4, 0, nan}};
    EXPECT_EQ(not_outside(low, high, -1, 2), 0b11011110u);
    EXPECT_EQ(not_outside(low, high, nan, nan), 0xffu);
}

ECODS_BEGIN_WIDE
std::uint64_t bytes_of(std::uint32_t mask) {
    return wide::bytes_of(mask);
}
ECODS_END_REGION
TEST(Wide, TurnsMasksToBytes) {
    if (!has_wide_registers()) GTEST_SKIP() << "no registers of sixteen floats";
    for (std::uint32_t mask = 0; mask < 256; ++mask) {
        std::uint64_t bytes = 0;
        for (int i = 0; i < 8; ++i)
            if (mask >> i & 1) bytes |= std::uint64_t{0xff} << (8 * i);
        ASSERT_EQ(bytes_of(mask), bytes);
    }
}

// Pairs taken out of a word, and what bits_of() makes of all ones in the lanes of some of them.
struct Taken {
    std::array<std::int32_t, 8> i, j;
    std::uint64_t bits, left, of_some;
};
ECODS_BEGIN_WIDE
Taken take_eight(std::uint64_t word, std::uint32_t some) {
    Taken taken{};
    const wide::PairNumbers pairs(word);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(taken.i.data()), pairs.i);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(taken.j.data()), pairs.j);
    Vec<std::int32_t, 8> lanes{};
    for (int lane = 0; lane < 8; ++lane) lanes[lane] = (some >> lane & 1) != 0 ? -1 : 0;
    taken.bits = pairs.bits;
    taken.left = word;
    taken.of_some = pairs.bits_of(lanes);
    return taken;
}
ECODS_END_REGION

TEST(Wide, TakesTheLowestEightPairsOfAWord) {
    if (!has_wide_registers()) GTEST_SKIP() << "no registers of sixteen floats";
    constexpr std::uint64_t words[] = {1,
                                       std::uint64_t{1} << 63,
                                       ~std::uint64_t{0},
                                       0x8000'0000'0000'00ff,
                                       0x0102'0408'1020'4080,
                                       0xf00f'0000'0000'0001,
                                       0x5555'5555'5555'5555};
    for (std::uint64_t word : words) {
        while (word != 0) {
            std::vector<int> numbers;
            std::uint64_t bits = 0;
            for (int bit = 0; bit < 64 && numbers.size() < 8; ++bit) {
                if ((word >> bit & 1) != 0) numbers.push_back(bit), bits |= std::uint64_t{1} << bit;
            }
            for (const std::uint32_t some : {0xffu, 0x01u, 0xaau, 0x00u}) {
                const Taken taken = take_eight(word, some);
                std::uint64_t of_some = 0;
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    const int number = numbers[lane < numbers.size() ? lane : 0];
                    EXPECT_EQ(taken.i[lane], number % 8);
                    EXPECT_EQ(taken.j[lane], number / 8);
                    if (lane < numbers.size() && (some >> lane & 1) != 0) of_some |= std::uint64_t{1} << number;
                }
                EXPECT_EQ(taken.bits, bits);
                EXPECT_EQ(taken.left, word & ~bits);
                EXPECT_EQ(taken.of_some, of_some);
            }
            word &= ~bits;
        }
    }
}

int of_four(int) noexcept {
    return 4;
}
int of_eight(int) noexcept {
    return 8;
}
int of_sixteen(int) noexcept {
    return 16;
}

TEST(Wide, EachInstructionSetHasTheWidthOfItsRegisters) {
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        const int width = call_widest<of_four, of_eight, of_sixteen>(0);
        EXPECT_EQ(width, set == InstructionSet::baseline ? 4 : set == InstructionSet::avx2 ? 8 : 16);
    }
}

}  // namespace
}  // namespace ecods

#endif
