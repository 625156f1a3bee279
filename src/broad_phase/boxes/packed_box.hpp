// Boxes packed for vector registers: one after the other, or eight per block, end by end.
//
// Everything here is integers (geometry/key_box.hpp) and comparisons, so it means the same on every instruction set.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/assert.hpp"
#include "geometry/key_box.hpp"
#include "simd/vec.hpp"

namespace ecods {

using KeyLanes = Vec<std::int64_t, 4>;

// A box as six numbers: the minima, and the complements of the maxima. Complements reverse the order, so that of each
// the smaller number reaches farther: containment, union and overlap are one operation for all. Two registers of four
// hold it, in which two numbers are twice.
struct PackedBox {
    static constexpr std::int64_t unreachable = std::numeric_limits<std::int64_t>::max();
    static constexpr std::size_t second = 2;  // where the second register begins

    std::array<std::int64_t, 6> ends = {unreachable, unreachable, unreachable,
                                        unreachable, unreachable, unreachable};  // the empty box

    friend bool operator==(const PackedBox&, const PackedBox&) = default;
    bool is_empty() const noexcept { return ends[0] == unreachable; }
};

// The same in registers.
struct BoxLanes {
    KeyLanes first, second;
};

// A box prepared for overlap tests: another one overlaps it if each of its ends is at most what is here for it. By
// registers, as a box is held in them.
struct alignas(64) BoxReach {
    std::array<std::int64_t, 8> ends;

    std::int64_t of(std::size_t end) const noexcept { return ends[end < 3 ? end : end + PackedBox::second]; }
};

ECODS_ALWAYS_INLINE KeyLanes lanes(const std::int64_t* first) noexcept {
    return load<KeyLanes>(first);
}
ECODS_ALWAYS_INLINE void load_lanes(const PackedBox& line, BoxLanes& lanes) noexcept {
    lanes.first = load_anywhere<KeyLanes>(line.ends.data());
    lanes.second = load_anywhere<KeyLanes>(line.ends.data() + PackedBox::second);
}
ECODS_ALWAYS_INLINE void store_lanes(const BoxLanes& lanes, PackedBox& line) noexcept {
    store_anywhere(line.ends.data(), lanes.first);
    store_anywhere(line.ends.data() + PackedBox::second, lanes.second);
}

// double_of() of each lane. In unsigned numbers, for ends of empty boxes are no keys of doubles, and would overflow.
ECODS_ALWAYS_INLINE Vec<double, 4> doubles_of(KeyLanes keys) noexcept {
    using Words = Vec<std::uint64_t, 4>;
    const Words signs = bits_as<Words>(keys < 0);
    return bits_as<Vec<double, 4>>(((bits_as<Words>(keys) ^ signs) - signs) | (signs & std::uint64_t{1} << 63));
}

// The keys of doubles, of which the bits are given.
ECODS_ALWAYS_INLINE KeyLanes keys_of(KeyLanes bits) noexcept {
    constexpr std::int64_t rest = std::numeric_limits<std::int64_t>::max();
    const KeyLanes signs = bits < 0;
    return ((bits & rest) ^ signs) - signs;
}

inline PackedBox packed_box(const KeyBox& box) noexcept {
    return {{box.min[0], box.min[1], box.min[2], ~box.max[0], ~box.max[1], ~box.max[2]}};
}
inline KeyBox key_box(const PackedBox& line) noexcept {
    return {{line.ends[0], line.ends[1], line.ends[2]}, {~line.ends[3], ~line.ends[4], ~line.ends[5]}};
}

// The box of which this is the packed one, which must not be empty.
inline Aabb box_of(const PackedBox& line) noexcept {
    ECODS_ASSERT(!line.is_empty());
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[static_cast<Eigen::Index>(axis)] = double_of(line.ends[axis]);
        box.max[static_cast<Eigen::Index>(axis)] = double_of(~line.ends[axis + 3]);
    }
    return box;
}

// packed_box(key_box(box)), in registers.
ECODS_ALWAYS_INLINE void make_lanes(const Aabb& box, BoxLanes& lanes) noexcept {
    static_assert(sizeof(Aabb) == 6 * sizeof(double));
    const auto* first = reinterpret_cast<const std::int64_t*>(box.min.data());  // read as vectors, which may alias
    lanes.first = keys_of(load_anywhere<KeyLanes>(first)) ^ KeyLanes { 0, 0, 0, -1 };
    lanes.second = keys_of(load_anywhere<KeyLanes>(first + PackedBox::second)) ^ KeyLanes { 0, -1, -1, -1 };
}
ECODS_ALWAYS_INLINE void make_packed_box(const Aabb& box, PackedBox& line) noexcept {
    BoxLanes lanes;
    make_lanes(box, lanes);
    store_lanes(lanes, line);
}

// What is there twice reaches everything in the register in which it is not used.
ECODS_ALWAYS_INLINE void make_reach(const PackedBox& line, BoxLanes& reach) noexcept {
    BoxLanes ends;
    load_lanes(line, ends);
    const KeyLanes everything = KeyLanes{} + PackedBox::unreachable;
    reach.first = shuffle<1, 2, 3, 4>(~ends.second, everything);
    reach.second = shuffle<4, 0, 1, 2>(~ends.first, everything);
}
ECODS_ALWAYS_INLINE void make_reach(const PackedBox& line, BoxReach& reach) noexcept {
    BoxLanes lanes;
    make_reach(line, lanes);
    store(&reach.ends[0], lanes.first);
    store(&reach.ends[4], lanes.second);
}

// Whether the closed boxes share a point. An empty box overlaps none.
ECODS_ALWAYS_INLINE bool overlaps(const PackedBox& line, const BoxLanes& reach) noexcept {
    BoxLanes ends;
    load_lanes(line, ends);
    return !any((ends.first > reach.first) | (ends.second > reach.second));
}
ECODS_ALWAYS_INLINE bool overlaps(const PackedBox& line, const BoxReach& reach) noexcept {
    return overlaps(line, BoxLanes{lanes(&reach.ends[0]), lanes(&reach.ends[4])});
}
inline bool overlap(const PackedBox& a, const PackedBox& b) noexcept {
    return overlap(key_box(a), key_box(b));
}

ECODS_ALWAYS_INLINE bool contains(const PackedBox& outer, const BoxLanes& inner) noexcept {
    BoxLanes ends;
    load_lanes(outer, ends);
    return !any((ends.first > inner.first) | (ends.second > inner.second));
}
ECODS_ALWAYS_INLINE bool contains(const PackedBox& outer, const PackedBox& inner) noexcept {
    BoxLanes ends;
    load_lanes(inner, ends);
    return contains(outer, ends);
}

inline void enlarge(PackedBox& line, const PackedBox& by) noexcept {
    for (std::size_t k = 0; k < 6; ++k) line.ends[k] = std::min(line.ends[k], by.ends[k]);
}

// Eight boxes, end by end.
struct alignas(64) BoxBlock {
    static constexpr std::uint32_t width = 8;

    std::array<std::array<std::int64_t, width>, 6> ends;

    BoxBlock() noexcept {
        for (auto& row : ends) row.fill(PackedBox::unreachable);
    }

    void set(std::size_t index, const PackedBox& line) noexcept {
        ECODS_ASSERT(index < width);
        for (std::size_t row = 0; row < 6; ++row) ends[row][index] = line.ends[row];
    }
    PackedBox get(std::size_t index) const noexcept {
        PackedBox line;
        for (std::size_t row = 0; row < 6; ++row) line.ends[row] = ends[row][index];
        return line;
    }
    // get(index) == line, faster.
    bool has(std::size_t index, const PackedBox& line) const noexcept {
        bool is_same = true;
        for (std::size_t row = 0; row < 6; ++row) is_same &= ends[row][index] == line.ends[row];
        return is_same;
    }
    // The smallest box that contains all. By values, of which none is branched on, as min_element() would.
    PackedBox bounds() const noexcept {
        PackedBox line;
        for (std::size_t row = 0; row < 6; ++row) {
            for (const std::int64_t end : ends[row]) line.ends[row] = end < line.ends[row] ? end : line.ends[row];
        }
        return line;
    }
};

// Bit i is set if box i overlaps.
ECODS_ALWAYS_INLINE std::uint32_t overlapping(const BoxBlock& block, const BoxReach& reach) noexcept {
    KeyLanes beyond[2] = {};
    for (std::size_t row = 0; row < 6; ++row) {
        const std::int64_t end = reach.of(row);
        beyond[0] |= lanes(&block.ends[row][0]) > end;
        beyond[1] |= lanes(&block.ends[row][4]) > end;
    }
    return static_cast<std::uint32_t>(
        any_bits((~beyond[0] & lane_bits<KeyLanes>(0)) | (~beyond[1] & lane_bits<KeyLanes>(4))));
}

}  // namespace ecods
