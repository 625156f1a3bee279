// Builds boxes and prisms.
#include <memory>
#include <string>
#include <vector>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/builders.hpp"
#include "geometry/find_invalid.hpp"
#include "query/builders/check_sizes.hpp"

namespace ecods {
namespace {

using namespace builders;

// Returns 1 if q is after p in lexicographic order, -1 if it is before p, 0 if the points are equal. Compares keys,
// because comparisons of doubles may take subnormal numbers for zero.
int way(const Vec2& p, const Vec2& q) noexcept {
    for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t from = key_of(p[axis]), to = key_of(q[axis]);
        if (from != to) return from < to ? 1 : -1;
    }
    return 0;
}

// Returns the indices of the points that differ from the point before, cyclically.
std::vector<std::size_t> distinct_points(std::span<const Vec2> polygon) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        for (int axis = 0; axis < 2; ++axis) {
            if (!is_finite(polygon[i][axis])) throw invalid_point(axis, polygon[i][axis]).at({}, i);
        }
        if (result.empty() || way(polygon[result.back()], polygon[i]) != 0) result.push_back(i);
    }
    while (result.size() > 1 && way(polygon[result.back()], polygon[result.front()]) == 0) result.pop_back();
    return result;
}

// Throws InvalidArgument unless the polygon is convex, or all of its points are on one line.
//
// A closed polygon that never turns right, or never turns left, is convex if it goes around once. In each turn around
// the polygon, its sides change twice between ascending and descending in lexicographic order. Sides that go back on
// their line change in the same way.
void require_convex(std::span<const Vec2> polygon) {
    const std::vector<std::size_t> kept = distinct_points(polygon);
    const auto point = [&](std::size_t k) { return polygon[kept[k % kept.size()]]; };
    int sense = 0, changes = 0;
    bool is_flat = true;
    std::size_t again = 0;  // the point at which the polygon begins to go around again
    for (std::size_t k = 1; k <= kept.size(); ++k) {
        const Vec2 before = point(k - 1), here = point(k), after = point(k + 1);
        if (way(before, here) != way(here, after) && ++changes == 3) again = kept[k % kept.size()];
        const int turn = static_cast<int>(orient2d(before, here, after));
        if (turn * sense < 0) throw polygon_not_convex(kept[k % kept.size()]);
        if (turn == 0) continue;
        is_flat = false;
        sense = turn;
    }
    if (changes > 2 && !is_flat) throw polygon_not_convex(again);
}

}  // namespace

std::shared_ptr<const ConvexSolid> box(const Vec3& sizes) {
    Vec3 half;
    for (int axis = 0; axis < 3; ++axis) half[axis] = require_half("sizes(" + std::to_string(axis) + ")", sizes[axis]);
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
                             (i & 4) != 0 ? half[2] : -half[2]);
    }
    return std::make_shared<const ConvexSolid>(corners);
}

std::shared_ptr<const ConvexSolid> prism(std::span<const Vec2> polygon, double height) {
    const double half = require_half("height", height);
    require_convex(polygon);
    std::vector<Vec3> points;
    for (const double z : {-half, half}) {
        for (const Vec2& p : polygon) points.emplace_back(p[0], p[1], z);
    }
    auto solid = std::make_shared<const ConvexSolid>(points);
    if (solid->dimension() < 3) throw no_interior(points.size());
    return solid;
}

}  // namespace ecods
