// mask_bits turns a mask of eight lanes into eight bits.
#pragma once

#include <cstdint>

#include "simd/vec.hpp"

namespace ecods {

// Returns an integer whose bit i is set if lane i of `mask` is set. The mask has eight lanes of 32 bits.
template <IsVec V>
ECODS_ALWAYS_INLINE std::uint32_t mask_bits(V mask) noexcept {
    static_assert(lane_count<V> == 8 && sizeof(LaneType<V>) == 4);
#if defined(__SSE2__)
    // The mask is split into halves: the baseline has an instruction for the signs of four lanes, but not of eight.
    // any_bits() would take twice as many instructions.
    const auto signs = bits_as<Vec<float, 8>>(mask);
    const Vec<float, 4> low = __builtin_shufflevector(signs, signs, 0, 1, 2, 3);
    const Vec<float, 4> high = __builtin_shufflevector(signs, signs, 4, 5, 6, 7);
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(low) | __builtin_ia32_movmskps(high) << 4);
#else
    return static_cast<std::uint32_t>(any_bits(mask & lane_bits<V>()));
#endif
}

}  // namespace ecods
