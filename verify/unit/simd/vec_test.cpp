#include "simd/vec.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "environment/instruction_sets.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using environment::InstructionSetLimit;
using environment::supported_instruction_sets;

// Numbers in memory, of which `first` is aligned for every vector.
template <class T, int N>
struct alignas(64) Memory {
    std::array<T, static_cast<std::size_t>(N) + 1> numbers{};
    T* first() { return numbers.data(); }
    T operator[](int i) const { return numbers[static_cast<std::size_t>(i)]; }
};

// What a vector operation gives for lanes of x and y, with those of the scalar operation.
template <class T, int N, class InVectors, class InNumbers>
ECODS_ALWAYS_INLINE void compare(InVectors in_vectors, InNumbers in_numbers, bool& is_same) {
    Memory<T, N> x, y, z;
    for (int i = 0; i < N; ++i) {
        x.first()[i] = static_cast<T>(i % 3 - 1) * static_cast<T>(i + 1);
        y.first()[i] = static_cast<T>(1 - i % 2) * static_cast<T>(3);
    }
    store(z.first(), in_vectors(load<Vec<T, N>>(x.first()), load<Vec<T, N>>(y.first())));
    for (int i = 0; i < N; ++i) is_same &= z[i] == in_numbers(x[i], y[i]);
    is_same &= z[N] == 0;
}

template <class T, int N>
ECODS_ALWAYS_INLINE bool holds_numbers(int) {
    using V = Vec<T, N>;
    bool holds = lane_count<V> == N && std::is_same_v<LaneType<V>, T>;
    compare<T, N>([](const V& a, const V& b) { return min(a, b); }, [](T a, T b) { return a < b ? a : b; }, holds);
    compare<T, N>([](const V& a, const V& b) { return max(a, b); }, [](T a, T b) { return a > b ? a : b; }, holds);
    compare<T, N>([](const V& a, const V& b) { return select(a < b, a + b, a - b); },
                  [](T a, T b) { return static_cast<T>(a < b ? a + b : a - b); }, holds);
    compare<T, N>([](const V& a, const V&) { return a * broadcast<V>(2); },
                  [](T a, T) { return static_cast<T>(2 * a); }, holds);
    if constexpr (std::is_floating_point_v<T>) {
        compare<T, N>([](const V& a, const V&) { return absolute(a); }, [](T a, T) { return a < 0 ? -a : a; }, holds);
    }
    // From the second number on, which is not aligned.
    Memory<T, N> x;
    for (int i = 0; i <= N; ++i) x.first()[i] = static_cast<T>(i);
    const V v = load_anywhere<V>(x.first() + 1);
    for (int i = 0; i < N; ++i) holds &= v[i] == static_cast<T>(i + 1);
    return holds;
}

// For each single lane.
template <class T, int N>
ECODS_ALWAYS_INLINE bool finds_lanes(int) {
    using V = Vec<T, N>;
    bool holds = !any(V{}) && !all(V{}) && all(~V{}) && any_bits(lane_bits<V>()) == (T{1} << N) - 1 &&
                 any_bits(lane_bits<V>(3)) == ((T{1} << N) - 1) << 3;
    for (int lane = 0; lane < N; ++lane) {
        V mask{};
        mask[lane] = -1;
        holds &= any(mask) && !all(mask) && !all(~mask);
        holds &= any_bits(mask & lane_bits<V>()) == T{1} << lane;
        holds &= lane > 5 || low_bytes(mask & lane_bits<V>(2)) == std::uint64_t{1} << (8 * lane + lane + 2);
    }
    return holds;
}

TEST(Vec, DoesInEachLaneWhatNumbersDo) {
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        EXPECT_TRUE((dispatch<holds_numbers<float, 4>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<float, 8>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<double, 2>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<double, 4>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<std::int64_t, 2>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<std::int64_t, 4>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<holds_numbers<std::int32_t, 8>>(0))) << environment::name(set);
    }
}

TEST(Vec, TellsWhichLanesOfAMaskAreSet) {
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        EXPECT_TRUE((dispatch<finds_lanes<std::int32_t, 4>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<finds_lanes<std::int32_t, 8>>(0))) << environment::name(set);
        EXPECT_TRUE((dispatch<finds_lanes<std::int64_t, 4>>(0))) << environment::name(set);
    }
}

TEST(Vec, MagnitudesAreOfBits) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Vec<double, 4> v = absolute(Vec<double, 4>{-0.0, -0x1p-1074, -nan, -std::numeric_limits<double>::infinity()});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(v[0]), 0u);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(v[1]), 1u);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(v[2]), std::bit_cast<std::uint64_t>(nan));
    EXPECT_EQ(v[3], std::numeric_limits<double>::infinity());
}

TEST(Vec, OfANanMinAndMaxAreTheSecond) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Vec<float, 4> a{nan, 1, nan, 2}, b{3, nan, nan, 4};
    const Vec<float, 4> least = min(a, b), most = max(a, b);
    EXPECT_EQ(least[0], 3);
    EXPECT_NE(least[1], least[1]);
    EXPECT_EQ(most[0], 3);
    EXPECT_NE(most[1], most[1]);
    EXPECT_EQ(most[3], 4);
}

TEST(Vec, LanesAreShuffledAndConverted) {
    const Vec<double, 4> a{0.75, -1.25, 2.5, 3}, b{4, 5, 6, 7};
    const Vec<double, 4> mixed = shuffle<1, 2, 7, 4>(a, b);
    EXPECT_EQ(mixed[0], -1.25);
    EXPECT_EQ(mixed[2], 7);
    EXPECT_EQ(mixed[3], 4);
    const auto whole = convert<Vec<std::int32_t, 4>>(a);
    EXPECT_EQ(whole[0], 0);
    EXPECT_EQ(whole[1], -1);
    EXPECT_EQ((convert<Vec<float, 4>>(a)[2]), 2.5f);
    EXPECT_EQ((bits_as<Vec<std::int64_t, 4>>(b)[0]), std::bit_cast<std::int64_t>(4.0));
}

}  // namespace
}  // namespace ecods
