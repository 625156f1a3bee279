// Searches among all vertices of a small hull, four at a time. Everything is inlined into what is compiled for the
// instruction set in use (simd/dispatch.hpp).
#pragma once

#include <cstdint>
#include <limits>

#include "query/convex/support_points.hpp"
#include "simd/inline.hpp"
#include "simd/vec.hpp"

namespace ecods::convex {

using FourDoubles = Vec<double, static_cast<int>(SupportPoints::lanes)>;
using FourIndices = MaskOf<FourDoubles>;

// Products of a vector with vertices, a group at a time.
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

// The greatest products seen in each lane, and the groups that they were in.
struct Best {
    FourDoubles most = broadcast<FourDoubles>(-std::numeric_limits<double>::infinity());
    FourIndices group{};

    ECODS_ALWAYS_INLINE void take(FourDoubles h, FourIndices at) noexcept {
        const FourIndices is_more = h > most;
        most = select(is_more, h, most);
        group = (is_more & at) | (~is_more & group);
    }
};

// The vertex of the greatest product with a vector, as doubles have it; the first one where all are NaN. Even and odd
// groups are two chains of comparisons, each of which waits for itself only.
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
    even.group = even.group * static_cast<std::int64_t>(lanes) + lane;
    odd.group = odd.group * static_cast<std::int64_t>(lanes) + lane;
    even.take(odd.most, odd.group);
    even.take(shuffle<2, 3, 0, 1>(even.most), shuffle<2, 3, 0, 1>(even.group));
    even.take(shuffle<1, 0, 3, 2>(even.most), shuffle<1, 0, 3, 2>(even.group));
    return static_cast<std::uint32_t>(even.group[0]);
}

// How many products are not less than a number: those of all places in the groups, those that the last vertex fills up
// included. NaN is not less.
ECODS_ALWAYS_INLINE std::size_t count_not_below(const double* groups, std::size_t count, const exact::Point& along,
                                                double least) noexcept {
    constexpr std::size_t lanes = SupportPoints::lanes;
    const Heights heights(along);
    const FourDoubles limit = broadcast<FourDoubles>(least);
    FourIndices even{}, odd{};  // the negative of how many are below
    for (std::size_t i = 0; i < count; i += 6 * lanes) {
        even += heights.of(groups + i) < limit;
        odd += heights.of(groups + i + 3 * lanes) < limit;
    }
    even += odd;
    const std::int64_t below = -(even[0] + even[1] + even[2] + even[3]);
    return count / 3 - static_cast<std::size_t>(below);
}

}  // namespace ecods::convex
