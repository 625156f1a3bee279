// A box as numbers, three axes at a time.
#pragma once

#include "broad_phase/boxes/packed_box.hpp"
#include "ecods/aabb.hpp"
#include "simd/vec.hpp"

namespace ecods {

// The fourth lanes are zero, but for what is computed in them.
struct BoxEnds {
    using Doubles = Vec<double, 4>;
    Doubles low, high;
};

ECODS_ALWAYS_INLINE BoxEnds::Doubles first_three(BoxEnds::Doubles v) noexcept {
    return shuffle<0, 1, 2, 4>(v, BoxEnds::Doubles{});
}
ECODS_ALWAYS_INLINE BoxEnds::Doubles last_three(BoxEnds::Doubles v) noexcept {
    return shuffle<1, 2, 3, 4>(v, BoxEnds::Doubles{});
}
ECODS_ALWAYS_INLINE double largest_of(BoxEnds::Doubles v) noexcept {
    const double m = v[0] > v[1] ? v[0] : v[1];
    return m > v[2] ? m : v[2];
}

ECODS_ALWAYS_INLINE void find_ends(const Aabb& box, BoxEnds& ends) noexcept {
    static_assert(sizeof(Aabb) == 6 * sizeof(double));
    ends.low = first_three(load_anywhere<BoxEnds::Doubles>(box.min.data()));
    ends.high = last_three(load_anywhere<BoxEnds::Doubles>(box.min.data() + PackedBox::second));
}
ECODS_ALWAYS_INLINE void find_ends(const BoxLanes& box, BoxEnds& ends) noexcept {
    ends.low = first_three(doubles_of(box.first));
    ends.high = last_three(doubles_of(~box.second));
}
ECODS_ALWAYS_INLINE void find_ends(const PackedBox& line, BoxEnds& ends) noexcept {
    BoxLanes lanes;
    load_lanes(line, lanes);
    find_ends(lanes, ends);
}

// The least box that contains both: rounding, in whatever direction, must not leave the second one outside.
ECODS_ALWAYS_INLINE void pack(const BoxEnds& ends, const BoxLanes& other, PackedBox& line) noexcept {
    const KeyLanes low = keys_of(bits_as<KeyLanes>(ends.low)), high = ~keys_of(bits_as<KeyLanes>(ends.high));
    store_lanes({min(shuffle<0, 1, 2, 4>(low, high), other.first), min(shuffle<2, 4, 5, 6>(low, high), other.second)},
                line);
}

}  // namespace ecods
