// mask_bits turns a mask of eight lanes into eight bits.
#pragma once

#include <cstdint>

#include "simd/vec.hpp"

namespace ecods {

// Sets bit i if lane i of a mask is set. The lanes are eight integers of 32 bits.
template <IsVec V>
ECODS_ALWAYS_INLINE std::uint32_t mask_bits(V mask) noexcept {
    static_assert(lane_count<V> == 8 && sizeof(LaneType<V>) == 4);
#if defined(__SSE2__)
    // Halves are used, since the baseline has an instruction for four signs at a time and none for eight; any_bits()
    // takes twice as many instructions.
    const auto signs = bits_as<Vec<float, 8>>(mask);
    const Vec<float, 4> low = __builtin_shufflevector(signs, signs, 0, 1, 2, 3);
    const Vec<float, 4> high = __builtin_shufflevector(signs, signs, 4, 5, 6, 7);
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(low) | __builtin_ia32_movmskps(high) << 4);
#else
    return static_cast<std::uint32_t>(any_bits(mask & lane_bits<V>()));
#endif
}

}  // namespace ecods
