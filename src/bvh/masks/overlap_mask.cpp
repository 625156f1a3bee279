#include "bvh/axes/separating_axes.hpp"
#include "bvh/masks/pair_kernel.hpp"
#include "simd/wide.hpp"

#define ECODS_TEXT "bvh/masks/flat_lanes_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/triangle_lanes_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/masks/overlap_text.hpp"
#include "simd/each_set.hpp"

#if ECODS_CAN_DISPATCH
ECODS_BEGIN_WIDE
namespace ecods::wide {
#include "bvh/masks/eight_pairs_text.hpp"
#include "bvh/masks/wide_overlap_text.hpp"
}  // namespace ecods::wide
ECODS_END_REGION
#endif

namespace ecods {
namespace {

template <class X, class Y>
TrianglePairs widest(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) noexcept {
#if ECODS_CAN_DISPATCH
    return call_widest<baseline::OverlapKernel::find<X, Y>, avx2::OverlapKernel::find<X, Y>,
                       wide::WideOverlap::find<X, Y>>(sets, x, y);
#else
    return baseline::OverlapKernel::find(sets, x, y);
#endif
}

}  // namespace

template <class X, class Y>
std::uint64_t overlap_mask(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) noexcept {
    return widest(sets, x, y).near;
}

#define ECODS_INSTANCE(X, Y) \
    template std::uint64_t overlap_mask(const std::array<AxisSet, 2>&, const X&, const Y&) noexcept;
ECODS_FOR_ALL_NODES(ECODS_INSTANCE)

TrianglePairs triangle_pairs(const std::array<AxisSet, 2>& sets, const TreeLeaf& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y);
}

}  // namespace ecods
