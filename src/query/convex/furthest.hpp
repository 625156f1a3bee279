// Searches all vertices of a small hull, or a list of numbers, four at a time. All functions here are inlined into code
// that is compiled for the instruction set in use (simd/dispatch.hpp).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "query/convex/support_points.hpp"
#include "simd/inline.hpp"
#include "simd/vec.hpp"

namespace ecods::convex {

using FourDoubles = Vec<double, static_cast<int>(SupportPoints::lanes)>;
using FourIndices = MaskOf<FourDoubles>;

// Calls use(lane) for each lane that is set in the mask.
template <class Use>
ECODS_ALWAYS_INLINE void for_each_lane(FourIndices mask, Use&& use) {
    auto bits = static_cast<std::uint64_t>(any_bits(mask & lane_bits<FourIndices>()));
    for (; bits != 0; bits &= bits - 1) use(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

// Computes the dot products of a vector with the vertices, a group of four vertices at a time.
struct Heights {
    FourDoubles x, y, z;

    ECODS_ALWAYS_INLINE explicit Heights(const exact::Point& along) noexcept
        : x(broadcast<FourDoubles>(along[0])),
          y(broadcast<FourDoubles>(along[1])),
          z(broadcast<FourDoubles>(along[2])) {}

    ECODS_ALWAYS_INLINE FourDoubles of(const double* group) const noexcept {
        constexpr std::size_t lanes = SupportPoints::lanes;
        return (x * load_anywhere<FourDoubles>(group) + y * load_anywhere<FourDoubles>(group + lanes)) +
               z * load_anywhere<FourDoubles>(group + 2 * lanes);
    }
};

// Best keeps, for each lane, the greatest number and its index. Of equal numbers the first is kept; NaN is skipped.
struct Best {
    FourDoubles most = broadcast<FourDoubles>(-std::numeric_limits<double>::infinity());
    FourIndices of{};

    ECODS_ALWAYS_INLINE void take(FourDoubles h, FourIndices at) noexcept {
        const FourIndices is_more = h > most;
        most = select(is_more, h, most);
        of = (is_more & at) | (~is_more & of);
    }
    // Returns the index of the greatest number of all lanes. Call this function last, because it overwrites the lanes.
    ECODS_ALWAYS_INLINE std::uint32_t of_greatest() noexcept {
        take(shuffle<2, 3, 0, 1>(most), shuffle<2, 3, 0, 1>(of));
        take(shuffle<1, 0, 3, 2>(most), shuffle<1, 0, 3, 2>(of));
        return static_cast<std::uint32_t>(of[0]);
    }
};

// Returns the vertex with the greatest dot product with a vector, in doubles; vertex 0 if all products are NaN. Even
// and odd groups form two independent chains of comparisons, which run in parallel.
ECODS_ALWAYS_INLINE std::uint32_t furthest(const double* groups, std::size_t count,
                                           const exact::Point& along) noexcept {
    constexpr std::size_t lanes = SupportPoints::lanes;
    const Heights heights(along);
    Best even, odd;
    FourIndices at{}, after = broadcast<FourIndices>(1);
    for (std::size_t i = 0; i < count; i += 6 * lanes) {
        even.take(heights.of(groups + i), at);
        odd.take(heights.of(groups + i + 3 * lanes), after);
        at += 2;
        after += 2;
    }
    constexpr FourIndices lane{0, 1, 2, 3};
    even.of = even.of * static_cast<std::int64_t>(lanes) + lane;
    odd.of = odd.of * static_cast<std::int64_t>(lanes) + lane;
    even.take(odd.most, odd.of);
    return even.of_greatest();
}

// Returns the index of the greatest number. The numbers are read four at a time.
ECODS_ALWAYS_INLINE std::uint32_t index_of_greatest(const double* numbers, std::size_t count) noexcept {
    Best best;
    FourIndices at{0, 1, 2, 3};
    for (std::size_t i = 0; i < count; i += SupportPoints::lanes) {
        best.take(load_anywhere<FourDoubles>(numbers + i), at);
        at += static_cast<std::int64_t>(SupportPoints::lanes);
    }
    return best.of_greatest();
}

// Returns the number of dot products that are at least `least` or NaN. All places of the groups count, also the copies
// of the last vertex.
ECODS_ALWAYS_INLINE std::size_t count_not_below(const double* groups, std::size_t count, const exact::Point& along,
                                                double least) noexcept {
    constexpr std::size_t lanes = SupportPoints::lanes;
    const Heights heights(along);
    const FourDoubles limit = broadcast<FourDoubles>(least);
    FourIndices even{}, odd{};  // by lane: minus the number of products below the limit
    for (std::size_t i = 0; i < count; i += 6 * lanes) {
        even += heights.of(groups + i) < limit;
        odd += heights.of(groups + i + 3 * lanes) < limit;
    }
    even += odd;
    const std::int64_t below = -(even[0] + even[1] + even[2] + even[3]);
    return count / 3 - static_cast<std::size_t>(below);
}

// Appends to `list` the vertices whose dot products are NaN, or are less than the greatest product by at most `below`.
ECODS_ALWAYS_INLINE void list_furthest(const SupportPoints& points, const exact::Point& along, double below,
                                       std::vector<std::uint32_t>& list) {
    const double* const groups = points.groups.data();
    const std::uint32_t last = points.vertex_count - 1;
    const std::uint32_t top = std::min(last, furthest(groups, points.groups.size(), along));
    const Heights heights(along);
    const FourDoubles least = broadcast<FourDoubles>(heights.of(groups + top / 4 * 12)[top % 4] - below);
    for (std::uint32_t v = 0; v <= last; v += 4) {
        for_each_lane(~(heights.of(groups + std::size_t{v} * 3) < least), [&](std::uint32_t lane) {
            if (v + lane <= last) list.push_back(v + lane);
        });
    }
}

}  // namespace ecods::convex
