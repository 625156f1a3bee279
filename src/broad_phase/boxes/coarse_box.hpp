// Boxes in half of their digits, which decide nearly all overlap tests.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

using CoarseLanes = Vec<std::int32_t, 8>;

// The upper halves of the six numbers of a packed box, cut off; one register of eight holds them, in which the last of
// each four is less than everything. Of two numbers whose upper halves differ, the halves show which is the lower one;
// only of equal halves nothing is known. Nothing is rounded here, as it would be in single precision, for two boxes may
// have come in different rounding modes. The upper half of a double has the sign, the exponent and 20 digits.
struct alignas(32) CoarseBox {
    static constexpr std::int32_t beyond_all = std::numeric_limits<std::int32_t>::max();

    std::array<std::int32_t, 8> ends = {beyond_all, beyond_all, beyond_all, ~beyond_all,
                                        beyond_all, beyond_all, beyond_all, ~beyond_all};  // of the empty box

    // A marked box is in doubt with every other: its last number and the lane that another has for it are equal then.
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

// What coarse boxes say of whether two overlap. Where ends are equal, or a box is marked, the boxes themselves must be
// asked; otherwise they overlap unless they are apart.
struct CoarseOverlap {
    bool are_apart, are_in_doubt;
};
ECODS_ALWAYS_INLINE CoarseOverlap coarse_overlap(const CoarseBox& a, const CoarseBox& b) noexcept {
    const CoarseLanes reach = ~shuffle<4, 5, 6, 7, 0, 1, 2, 3>(load<CoarseLanes>(a.ends.data()));
    const CoarseLanes ends = load<CoarseLanes>(b.ends.data());
    return {any(ends > reach), any(ends == reach)};
}

}  // namespace ecods
