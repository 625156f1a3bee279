#include <algorithm>

#include "bvh/axes/motion_axes.hpp"
#include "bvh/axes/swept_axes.hpp"
#include "bvh/masks/pair_kernel.hpp"

#define ECODS_TEXT "bvh/masks/time_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/swept_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/meeting_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {

template <class X, class Y>
std::uint64_t swept_mask(const std::array<SweptSet, 2>& sets, float limit, const X& x, const Y& y,
                         LaneBounds& times) noexcept {
    return call_widest<ECODS_OF_EACH_SET(swept_kernel<X, Y>)>(sets, limit, x, y, times);
}
template <class X, class Y>
std::uint64_t meeting_mask(const std::array<MotionSet, 2>& sets, float limit, const X& x, const Y& y,
                           LaneBounds& times) noexcept {
    return call_widest<ECODS_OF_EACH_SET(meeting_kernel<X, Y>)>(sets, limit, x, y, times);
}

#define ECODS_INSTANCE(X, Y)                                                                          \
    template std::uint64_t swept_mask(const std::array<SweptSet, 2>&, float, const X&, const Y&,      \
                                      LaneBounds&) noexcept;                                          \
    template std::uint64_t meeting_mask(const std::array<MotionSet, 2>&, float, const NodeAtEnds<X>&, \
                                        const NodeAtEnds<Y>&, LaneBounds&) noexcept;
ECODS_FOR_ALL_NODES(ECODS_INSTANCE)

}  // namespace ecods
