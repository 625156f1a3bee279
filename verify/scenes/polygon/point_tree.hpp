// Points in the plane, found by triangles.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/primitives.hpp"

namespace ecods::scenes {

// orient2d, but fast where that is easy: two points are one, all have one coordinate, or the rounded determinant is
// beyond its error. Each difference has a relative error of u at most, each product one more and, where it is below the
// normal doubles, 2^-1075; so |rounded - true| <= u |rounded| + (3 u + 4 u^2) (|left| + |right|) + 2^-1074, which is
// less than 5 u (|left| + |right|) + 2^-1000 with all roundings of this, too. What overflows is no number, and decides
// nothing.
inline Sign turn(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
    const bool is_on_a_line =
        (a[0] == b[0] && a[0] == c[0]) || (a[1] == b[1] && a[1] == c[1]) || a == b || b == c || a == c;
    if (is_on_a_line) return Sign::zero;
    constexpr double u = 0x1p-53;
    const double left = (b[0] - a[0]) * (c[1] - a[1]);
    const double right = (b[1] - a[1]) * (c[0] - a[0]);
    const double determinant = left - right;
    const double bound = 5 * u * (std::abs(left) + std::abs(right)) + 0x1p-1000;
    if (determinant > bound) return Sign::positive;
    if (determinant < -bound) return Sign::negative;
    return orient2d(a, b, c);
}

// A closed triangle that is not clockwise; its sides are a b, b c and c a. It may be a segment or a point.
class PlaneTriangle {
  public:
    PlaneTriangle(const Vec2& a, const Vec2& b, const Vec2& c);

    // On which side of each side the point is: positive on the inner one.
    Sign side(std::size_t k, const Vec2& point) const noexcept { return turn(corners_[k], corners_[k + 1], point); }

    // True if it has the point; then `sides` are those of the point.
    bool contains(const Vec2& point, std::array<Sign, 3>& sides) const noexcept;

    // False only if it has no point of the box.
    bool may_meet(const Vec2& lower, const Vec2& upper) const noexcept;

  private:
    std::array<Vec2, 4> corners_;  // the first one twice
    Vec2 lower_;
    Vec2 upper_;
};

// A k-d tree. Refers to the points. Cost: O(n log n) to build, O(log n) to remove a point.
class PointTree {
  public:
    explicit PointTree(std::span<const Vec2> points);

    void remove(std::uint32_t point) noexcept;

    // Calls visit(point, sides) for each point of the triangle that was not removed, until it returns true; true if it
    // did.
    template <class Visit>
    bool visit_in(const PlaneTriangle& triangle, const Visit& visit) const {
        std::array<std::uint32_t, 2 * max_depth> stack{};
        std::size_t size = 1;
        while (size > 0) {
            const std::uint32_t at = stack[--size];
            const Node& node = nodes_[at];
            if (node.left_count == 0 || !triangle.may_meet(node.lower, node.upper)) continue;
            if (at < first_leaf_) {
                stack[size++] = 2 * at + 1;
                stack[size++] = 2 * at + 2;
                continue;
            }
            std::array<Sign, 3> sides{};
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const std::uint32_t point = order_[i];
                if (is_removed_[point] == 0 && triangle.contains(points_[point], sides) && visit(point, sides))
                    return true;
            }
        }
        return false;
    }

  private:
    static constexpr std::size_t max_depth = 32;  // of indices of 32 bits
    struct Node {
        Vec2 lower, upper;
        std::uint32_t begin = 0, end = 0;  // in order_
        std::uint32_t left_count = 0;      // points that were not removed
    };

    void build(std::uint32_t at);

    std::span<const Vec2> points_;
    std::vector<Node> nodes_;  // the children of node k are 2 k + 1 and 2 k + 2; all leaves are equally deep
    std::uint32_t first_leaf_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> leaf_of_;
    std::vector<char> is_removed_;
};

}  // namespace ecods::scenes
