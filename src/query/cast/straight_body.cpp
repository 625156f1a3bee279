#include "query/cast/straight_body.hpp"

#include <algorithm>

namespace ecods {

void StraightBody::bind(const MeshTree& tree, const Pose& at_start, const Pose& at_end, const Vec3& beside) {
    from = &at_start;
    to = &at_end;
    way = at_end.t - at_start.t;
    const Mat3 sizes = at_start.R.cwiseAbs(), end_sizes = at_end.R.cwiseAbs();
    size = (sizes * tree.extent.magnitude).sum() + sum_of(beside);
    end_size = (end_sizes * tree.extent.magnitude).sum() + sum_of(way);
    const Vec3 half_at_start = sizes * tree.extent.half, half_at_end = end_sizes * tree.extent.half;
    half = half_at_start.cwiseMax(half_at_end);
    least = std::min(half_at_start.norm(), half_at_end.norm());
}

}  // namespace ecods
