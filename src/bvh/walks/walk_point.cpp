#include "bvh/walks/walk_point.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "bvh/masks/projected_lanes.hpp"
#include "bvh/masks/triangle_bounds.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

#define ECODS_TEXT "bvh/masks/triangle_bounds_text.hpp"
#include "simd/each_set.hpp"
#define ECODS_TEXT "bvh/walks/walk_point_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {

void walk_point(const MeshBvh& tree, const PointAxes& axes, PointWalk& walk) {
    walk.found.clear();
    walk.limit = std::numeric_limits<float>::infinity();
    call_widest<ECODS_OF_EACH_SET(PointLanes::run)>(tree, axes, walk);
    std::erase_if(walk.found, [&](const NearTriangle& near) { return near.lower > walk.limit; });
}

}  // namespace ecods
