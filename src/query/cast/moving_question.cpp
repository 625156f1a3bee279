#include "query/cast/moving_question.hpp"

#include "base/arithmetic.hpp"

namespace ecods {

namespace {

// Returns a node whose single child is the box of the tree's root.
BvhNode root_of(const MeshBvh& tree) {
    BvhNode node{};
    for (std::size_t k = 0; k < 3; ++k) {
        node.center[k].fill(tree.root_center[k]);
        node.half[k].fill(tree.root_half[k]);
    }
    node.count = 1;
    return node;
}

}  // namespace

std::optional<float> first_of_roots(const MotionAxes& axes, const TreeAtEnds& a, const TreeAtEnds& b) {
    const BvhNode from_a = root_of(a.start()), to_a = root_of(a.end()), from_b = root_of(b.start()),
                  to_b = root_of(b.end());
    alignas(32) LaneBounds times;
    if (meeting_mask(axes.sets(), 1, NodeAtEnds(from_a, to_a), NodeAtEnds(from_b, to_b), times) == 0)
        return std::nullopt;
    return times[0];
}

void StraightMotion::bind_boxes(const MeshAtEnds& a, const MeshAtEnds& b) {
    const Pose &from_a = a.start.pose, &to_a = *a.end.pose, &from_b = b.start.pose, &to_b = *b.end.pose;
    trees_ = {a.trees, b.trees};
    const MovingTree tree_a(a.trees, from_a.R, to_a.R), tree_b(b.trees, from_b.R, to_b.R);
    const Vec3 d_from = from_b.t - from_a.t, d_to = to_b.t - to_a.t;
    const double off = a.end_off + b.end_off;  // on each axis, so points are off by less than twice that
    if (off > 0) return axes_.bind(tree_a, tree_b, d_from, d_to, {.everywhere = 2 * off * (1 + 16 * two_u)});
    axes_.bind(tree_a, tree_b, d_from, d_to);
}

std::optional<float> StraightBoxes::first_of_boxes() {
    return first_of_roots(axes_, trees_[0], trees_[1]);
}

}  // namespace ecods
