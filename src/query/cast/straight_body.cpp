#include "query/cast/straight_body.hpp"

#include "base/arithmetic.hpp"

namespace ecods {

void StraightBody::bind(const MeshTree& tree, const Pose& at_start, const Pose& at_end, const Vec3& beside) {
    from = &at_start;
    to = &at_end;
    way = at_end.t - at_start.t;
    const Mat3 sizes = at_start.R.cwiseAbs(), end_sizes = at_end.R.cwiseAbs();
    size = (sizes * tree.extent.magnitude).sum() + sum_of(beside);
    end_size = (end_sizes * tree.extent.magnitude).sum() + sum_of(way);
    half = (sizes * tree.extent.half).cwiseMax(end_sizes * tree.extent.half);
    way_length = length_above(way) * (1 + 4 * two_u);
}

}  // namespace ecods
