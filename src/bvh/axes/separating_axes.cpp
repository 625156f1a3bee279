#include "bvh/axes/separating_axes.hpp"

#include <bit>

#include "bvh/axes/posed_axes.hpp"
#include "simd/double8.hpp"

#define ECODS_TEXT "bvh/axes/separating_edges_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/axes/separating_text.hpp"
#include "simd/each_set.hpp"

#if ECODS_CAN_DISPATCH
ECODS_BEGIN_WIDE
namespace ecods::wide {
#include "bounds/double4_text.hpp"
#include "bvh/axes/posed_axes_text.hpp"
#include "bvh/axes/separating_edges_text.hpp"

#include "bvh/axes/both_axes_text.hpp"
}  // namespace ecods::wide
ECODS_END_REGION
#endif

namespace ecods {

int SeparatingAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d, int first) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) {
#if ECODS_CAN_DISPATCH
        return call_widest<baseline::bind_axis_sets, avx2::bind_axis_sets, wide::bind_both_axis_sets>(sets_, a, b, d,
                                                                                                      first);
#else
        return baseline::bind_axis_sets(sets_, a, b, d, first);
#endif
    }
    // An unbounded tree is never separated from another.
    for (AxisSet& set : sets_) {
        set = {};
        set.set_unbounded();
    }
    return -1;
}

}  // namespace ecods
