#include "bvh/masks/triangle_bounds.hpp"

#include <algorithm>
#include <limits>

#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

#define ECODS_TEXT "bvh/masks/triangle_bounds_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {

void put_on_axes(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y, LeavesOnAxes& leaves) noexcept {
    call_widest<ECODS_OF_EACH_SET(BoundsKernel::put)>(set, x, y, leaves);
}

void bound_triangles(const DistanceSet& set, const TriangleBatch& batch, TriangleSquares& squares) noexcept {
    call_widest<ECODS_OF_EACH_SET(BoundsKernel::bound)>(set, batch, squares);
}

}  // namespace ecods
