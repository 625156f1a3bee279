#include "scenes/polygon/point_tree.hpp"

#include <algorithm>
#include <numeric>

namespace ecods::scenes {

PlaneTriangle::PlaneTriangle(const Vec2& a, const Vec2& b, const Vec2& c)
    : corners_{a, b, c, a}, lower_(a.cwiseMin(b).cwiseMin(c)), upper_(a.cwiseMax(b).cwiseMax(c)) {}

bool PlaneTriangle::contains(const Vec2& point, std::array<Sign, 3>& sides) const noexcept {
    if ((point.array() < lower_.array()).any() || (point.array() > upper_.array()).any()) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        sides[k] = side(k, point);
        if (sides[k] == Sign::negative) return false;
    }
    return true;
}

bool PlaneTriangle::may_meet(const Vec2& lower, const Vec2& upper) const noexcept {
    if ((upper.array() < lower_.array()).any() || (lower.array() > upper_.array()).any()) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& from = corners_[k];
        const Vec2& to = corners_[k + 1];
        // The corner of the box that is furthest on the inner side, which is to the left.
        const Vec2 corner(from[1] > to[1] ? upper[0] : lower[0], from[0] < to[0] ? upper[1] : lower[1]);
        if (side(k, corner) == Sign::negative) return false;
    }
    return true;
}

PointTree::PointTree(std::span<const Vec2> points)
    : points_(points), order_(points.size()), leaf_of_(points.size()), is_removed_(points.size(), 0) {
    constexpr std::size_t leaf_size = 8;
    std::iota(order_.begin(), order_.end(), 0U);
    while ((points.size() >> first_leaf_) > leaf_size) ++first_leaf_;
    first_leaf_ = (1U << first_leaf_) - 1;
    nodes_.resize(2 * std::size_t{first_leaf_} + 1);
    nodes_[0].end = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t at = 0; at < nodes_.size(); ++at) build(at);
}

void PointTree::build(std::uint32_t at) {
    Node& node = nodes_[at];
    node.left_count = node.end - node.begin;
    if (node.left_count == 0) return;
    node.lower = node.upper = points_[order_[node.begin]];
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
        node.lower = node.lower.cwiseMin(points_[order_[i]]);
        node.upper = node.upper.cwiseMax(points_[order_[i]]);
    }
    if (at >= first_leaf_) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) leaf_of_[order_[i]] = at;
        return;
    }
    // Halves: a width beyond the doubles is infinite, and compares as it should.
    const Vec2 width = node.upper - node.lower;
    const Eigen::Index axis = width[0] > width[1] ? 0 : 1;
    const std::uint32_t middle = node.begin + node.left_count / 2;
    std::nth_element(order_.begin() + node.begin, order_.begin() + middle, order_.begin() + node.end,
                     [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    nodes_[2 * at + 1].begin = node.begin;
    nodes_[2 * at + 1].end = nodes_[2 * at + 2].begin = middle;
    nodes_[2 * at + 2].end = node.end;
}

void PointTree::remove(std::uint32_t point) noexcept {
    is_removed_[point] = 1;
    for (std::uint32_t at = leaf_of_[point];; at = (at - 1) / 2) {
        --nodes_[at].left_count;
        if (at == 0) return;
    }
}

}  // namespace ecods::scenes
