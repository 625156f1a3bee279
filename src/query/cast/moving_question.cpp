#include "query/cast/moving_question.hpp"

namespace ecods {

BvhNode root_of(const MeshBvh& tree) {
    BvhNode node{};
    for (std::size_t k = 0; k < 3; ++k) {
        node.center[k].fill(tree.root_center[k]);
        node.half[k].fill(tree.root_half[k]);
    }
    node.count = 1;
    return node;
}

void StraightMotion::bind_boxes(const Moving<MeshShape>& a, const Moving<MeshShape>& b) {
    trees_ = {&MeshShapeAccess::tree(*a.what).boxes, &MeshShapeAccess::tree(*b.what).boxes};
    axes_.bind({*trees_[0], a.from.R, a.to.R}, {*trees_[1], b.from.R, b.to.R}, b.from.t - a.from.t, b.to.t - a.to.t);
}

std::optional<float> StraightMotion::first_of_boxes() {
    alignas(32) LaneBounds times;
    if (meeting_mask(axes_.sets(), 1, root_of(*trees_[0]), root_of(*trees_[1]), times) == 0) return std::nullopt;
    return times[0];
}

}  // namespace ecods
