// Packs boxes for vector registers: single boxes, or blocks of eight with a row for each end.
//
// All operations are on integers (geometry/key_box.hpp), so they give the same results with every instruction set.
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

// Holds a box as six integers: the minima, and the complements of the maxima. Complements reverse the order, so on each
// of the six sides, the box with the smaller number reaches farther. Containment, union and overlap are then one
// operation for all sides. Two registers of four hold the six numbers; both have the numbers 2 and 3.
struct PackedBox {
    static constexpr std::int64_t unreachable = std::numeric_limits<std::int64_t>::max();
    static constexpr std::size_t second = 2;  // index of the first number in the second register

    std::array<std::int64_t, 6> ends = {unreachable, unreachable, unreachable,
                                        unreachable, unreachable, unreachable};  // the empty box

    friend bool operator==(const PackedBox&, const PackedBox&) = default;
    bool is_empty() const noexcept { return ends[0] == unreachable; }
};

// Holds a packed box in registers.
struct BoxLanes {
    KeyLanes first, second;
};

// Holds a box prepared for overlap tests: a packed box overlaps it exactly if each of the packed box's ends is at most
// the number at the same place here. The numbers are laid out as in two registers.
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

// Returns double_of() of each lane. Computes with unsigned numbers: ends of empty boxes are no keys of doubles, and
// signed numbers would overflow.
ECODS_ALWAYS_INLINE Vec<double, 4> doubles_of(KeyLanes keys) noexcept {
    using Words = Vec<std::uint64_t, 4>;
    const Words signs = bits_as<Words>(keys < 0);
    return bits_as<Vec<double, 4>>(((bits_as<Words>(keys) ^ signs) - signs) | (signs & std::uint64_t{1} << 63));
}

// Returns the keys of the doubles with these bits.
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

// Returns the box that `line` packs; it must not be empty.
inline Aabb box_of(const PackedBox& line) noexcept {
    ECODS_ASSERT(!line.is_empty());
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[static_cast<Eigen::Index>(axis)] = double_of(line.ends[axis]);
        box.max[static_cast<Eigen::Index>(axis)] = double_of(~line.ends[axis + 3]);
    }
    return box;
}

// Sets `lanes` to the registers of packed_box(key_box(box)).
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

// Sets `reach` to the box in `line`, prepared for overlap tests. Both registers of a packed box have the numbers 2 and
// 3, but each of these is compared in one register only. At its place in the other register, `reach` has the greatest
// number, which no end exceeds.
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

// Returns true if the closed boxes share a point. An empty box overlaps none.
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

// Holds eight boxes, with a row for each end.
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
    // Returns true if get(index) == line. The call is faster than that comparison.
    bool has(std::size_t index, const PackedBox& line) const noexcept {
        bool is_same = true;
        for (std::size_t row = 0; row < 6; ++row) is_same &= ends[row][index] == line.ends[row];
        return is_same;
    }
    // Returns the smallest box that contains all eight. Compares values without branches, unlike min_element().
    PackedBox bounds() const noexcept {
        PackedBox line;
        for (std::size_t row = 0; row < 6; ++row) {
            for (const std::int64_t end : ends[row]) line.ends[row] = end < line.ends[row] ? end : line.ends[row];
        }
        return line;
    }
};

// Returns a mask: bit i is set if box i of the block overlaps the box of `reach`.
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
