#include "scenes/polygon/cut_polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/polygon/plane_map.hpp"

namespace ecods::scenes {
namespace {

using Corners = std::span<const std::uint32_t>;

Vec2 project(const Vec3& point, int axis) {
    return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

// Newell's normal, rounded: twice the areas in the three projections, up to a common factor. It chooses what is tried
// first, and nothing else.
Vec3 rounded_normal(std::span<const Vec3> vertices, Corners corners) {
    // Half of each difference is below the largest double, and what is scaled by the largest has no product above 1.
    const Vec3 origin = 0.5 * vertices[corners[0]];
    double largest = 0;
    for (const std::uint32_t corner : corners) {
        largest = std::max(largest, (0.5 * vertices[corner] - origin).cwiseAbs().maxCoeff());
    }
    if (largest == 0) return Vec3::Zero();
    const int exponent = -std::ilogb(largest) - 1;
    const auto scaled = [&](std::uint32_t corner) -> Vec3 {
        return (0.5 * vertices[corner] - origin).unaryExpr([&](double x) { return std::scalbn(x, exponent); });
    };
    Vec3 normal = Vec3::Zero();
    Vec3 before = scaled(corners.back());
    for (const std::uint32_t corner : corners) {
        const Vec3 point = scaled(corner);
        normal += before.cross(point);
        before = point;
    }
    return normal;
}

// Seen from the side from which it goes round counter-clockwise, if `is_clockwise` is right.
PlaneWalk outline_of(std::span<const Vec3> vertices, Corners corners, int axis, bool is_clockwise) {
    PlaneWalk outline;
    for (const std::uint32_t corner : corners) {
        Vec2 point = project(vertices[corner], axis);
        if (is_clockwise) point[1] = -point[1];
        outline.add(point, corner);
    }
    return outline;
}

bool is_on_a_line(const PlaneWalk& outline) {
    const std::vector<Vec2>& points = outline.points;
    const auto other = std::find_if(points.begin(), points.end(), [&](const Vec2& p) { return p != points[0]; });
    return std::all_of(other, points.end(),
                       [&](const Vec2& p) { return orient2d(points[0], *other, p) == Sign::zero; });
}

// True if the fan around the first corner has counter-clockwise triangles that do not go round it once and more: seen
// from there, the corners are first to the left of the second one, and then to its right.
bool is_fan(const PlaneWalk& outline) {
    const std::vector<Vec2>& points = outline.points;
    Sign side = Sign::positive;
    for (std::size_t i = 2; i < points.size(); ++i) {
        if (orient2d(points[0], points[i - 1], points[i]) != Sign::positive) return false;
        const Sign next = orient2d(points[0], points[1], points[i]);
        if (next > side || (next == side && next == Sign::zero)) return false;
        side = next;
    }
    return true;
}

// Cuts each face of the map, inside and outside of the outline. Their triangles cover the box once, because the box is
// their outer boundary and none of them is clockwise. So those of faces around which the outline goes once, and no
// others, cover these once. An edge between faces around which it does not go is a spike.
bool cut_outline(const PlaneWalk& outline, std::vector<Triangle>& triangles) {
    const auto map = PlaneMap::create(outline);
    if (!map) return false;
    const auto windings = map->windings();
    if (!windings) return false;
    const std::vector<HalfEdge>& half_edges = map->half_edges();
    std::vector<Triangle> ears;
    for (std::uint32_t face = 1; face < windings->size(); ++face) {
        const int winding = (*windings)[face];
        ears.clear();
        if (winding < 0 || winding > 1 || !cut_ears(map->walk_round(face), ears)) return false;
        if (winding == 0) continue;
        for (const auto& [a, b, c] : ears)
            triangles.push_back({half_edges[a].name, half_edges[b].name, half_edges[c].name});
    }
    for (std::size_t i = 0; i < half_edges.size(); i += 2) {
        const HalfEdge& there = half_edges[i];
        const HalfEdge& back = half_edges[i + 1];
        if (there.is_walked && (*windings)[there.face] == 0 && (*windings)[back.face] == 0)
            triangles.push_back({there.name, back.name, back.name});
    }
    return true;
}

void add_fan(Corners corners, std::vector<Triangle>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

PolygonCut cut_polygon(std::span<const Vec3> vertices, Corners corners, std::vector<Triangle>& triangles) {
    if (corners.size() == 3) {
        add_fan(corners, triangles);
        return PolygonCut::fan;
    }
    const Vec3 normal = rounded_normal(vertices, corners);
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return std::abs(normal[a]) > std::abs(normal[b]); });
    PolygonCut cut = PolygonCut::fan;
    for (const int axis : axes) {
        for (const bool is_second : {false, true}) {
            const PlaneWalk outline = outline_of(vertices, corners, axis, (normal[axis] < 0) != is_second);
            if (is_fan(outline)) {
                add_fan(corners, triangles);
                return PolygonCut::fan;
            }
            if (is_on_a_line(outline)) break;
            cut = PolygonCut::crossing;
            std::vector<Triangle> ears;
            if (cut_outline(outline, ears)) {
                triangles.insert(triangles.end(), ears.begin(), ears.end());
                return PolygonCut::ears;
            }
        }
    }
    add_fan(corners, triangles);
    return cut;
}

bool is_in_a_plane(std::span<const Vec3> vertices, Corners corners) {
    const Vec3& a = vertices[corners[0]];
    const Vec3* b = nullptr;
    const Vec3* c = nullptr;
    for (const std::uint32_t corner : corners) {
        const Vec3& d = vertices[corner];
        if (b == nullptr) {
            if (d != a) b = &d;
        } else if (c == nullptr) {
            for (int axis = 0; axis < 3; ++axis) {
                if (orient2d(project(a, axis), project(*b, axis), project(d, axis)) != Sign::zero) c = &d;
            }
        } else if (orient3d(a, *b, *c, d) != Sign::zero) {
            return false;
        }
    }
    return true;
}

}  // namespace ecods::scenes
