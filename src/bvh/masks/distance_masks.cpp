#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/far_gap.hpp"
#include "bvh/masks/pair_kernel.hpp"

#define ECODS_TEXT "bvh/masks/near_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/far_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/nearest_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {

template <class X, class Y>
std::uint64_t near_mask(const std::array<DistanceSet, 2>& sets, const Direction& n, float limit, const X& x, const Y& y,
                        LaneBounds& squares) noexcept {
    return call_widest<ECODS_OF_EACH_SET(near_kernel<X, Y>)>(sets, n, limit, x, y, squares);
}
template <class X, class Y>
std::uint64_t far_mask(const FarGap& gap, float limit, const X& x, const Y& y, LaneBounds& ranks) noexcept {
    return call_widest<ECODS_OF_EACH_SET(FarKernel::find<X, Y>)>(gap, limit, x, y, ranks);
}
template <class X, class Y>
LanePair nearest_lanes(const DistanceSet& set, const X& x, const Y& y) noexcept {
    return call_widest<ECODS_OF_EACH_SET(NearestKernel::find<X, Y>)>(set, x, y);
}

#define ECODS_INSTANCE(X, Y)                                                                                         \
    template std::uint64_t near_mask(const std::array<DistanceSet, 2>&, const Direction&, float, const X&, const Y&, \
                                     LaneBounds&) noexcept;                                                          \
    template std::uint64_t far_mask(const FarGap&, float, const X&, const Y&, LaneBounds&) noexcept;                 \
    template LanePair nearest_lanes(const DistanceSet&, const X&, const Y&) noexcept;
ECODS_FOR_ALL_NODES(ECODS_INSTANCE)

}  // namespace ecods
