// Defines boxes with half of the bits of each coordinate, which decide nearly all overlap tests.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

using CoarseLanes = Vec<std::int32_t, 8>;

// Holds the upper halves of the six numbers of a packed box in one register of eight. Each half of the register has
// three numbers, followed by a number that is less than all others. If two upper halves differ, they are ordered as the
// numbers are; if they are equal, the order is unknown. The upper half of a double has the sign, the exponent and 20
// bits of the mantissa. Rounding to single precision would not do, as two boxes may be added in different rounding
// modes.
struct alignas(32) CoarseBox {
    static constexpr std::int32_t beyond_all = std::numeric_limits<std::int32_t>::max();

    std::array<std::int32_t, 8> ends = {beyond_all, beyond_all, beyond_all, ~beyond_all,
                                        beyond_all, beyond_all, beyond_all, ~beyond_all};  // the empty box

    // Makes the overlap of this box with any other box doubtful: the last number then equals the lane that it is
    // compared with.
    void mark() noexcept { ends[7] = beyond_all; }
    void unmark() noexcept { ends[7] = ~beyond_all; }

    friend bool operator==(const CoarseBox&, const CoarseBox&) = default;
};

ECODS_ALWAYS_INLINE void make_coarse_box(const BoxLanes& box, CoarseBox& coarse) noexcept {
    static_assert(std::endian::native == std::endian::little);
    const auto first = bits_as<CoarseLanes>(box.first), second = bits_as<CoarseLanes>(box.second);
    constexpr CoarseLanes kept = {-1, -1, -1, 0, -1, -1, -1, 0};
    const CoarseLanes halves = shuffle<1, 3, 5, 7, 11, 13, 15, 9>(first, second);
    store(coarse.ends.data(), (halves & kept) | (~kept & ~CoarseBox::beyond_all));
}
ECODS_ALWAYS_INLINE void make_coarse_box(const PackedBox& line, CoarseBox& coarse) noexcept {
    BoxLanes lanes;
    load_lanes(line, lanes);
    make_coarse_box(lanes, coarse);
}

// Holds the result of comparing two coarse boxes. If ends are equal or a box is marked, `are_in_doubt` is true, and the
// packed boxes must be compared. Otherwise the boxes overlap exactly if `are_apart` is false.
struct CoarseOverlap {
    bool are_apart, are_in_doubt;
};
ECODS_ALWAYS_INLINE CoarseOverlap coarse_overlap(const CoarseBox& a, const CoarseBox& b) noexcept {
    const CoarseLanes reach = ~shuffle<4, 5, 6, 7, 0, 1, 2, 3>(load<CoarseLanes>(a.ends.data()));
    const CoarseLanes ends = load<CoarseLanes>(b.ends.data());
    return {any(ends > reach), any(ends == reach)};
}

}  // namespace ecods
