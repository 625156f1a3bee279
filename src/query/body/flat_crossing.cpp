// Decides whether the relative interiors of two convex sets that are in no common plane share a point. This is possible
// only if one set is a polygon, and the other set has points on both sides of the polygon's plane.
//
// A segment with ends strictly on both sides of a polygon's plane passes through its interior if and only if its line
// has all edges of the polygon on one side: signs of orient3d.
//
// Let A and B be two polygons, each with points on both sides of the other one's plane. They meet the line of both
// planes in segments of positive length, from a0 to a1 and from b0 to b1. Their interiors share a point if and only if
// a0 < b1 and b0 < a1. Let n and m be the normals around which A and B go counterclockwise, and n x m the direction of
// the line. An edge of A, directed towards positive heights over B, and one of B, directed towards positive heights
// over A, meet the line at points x and y. Then orient3d of the ends of both has the sign of y - x: moving the ends of
// an edge along its line keeps the sign, so it is that of det(e, y - x, f) for the directions e and f, and det(e, n x
// m, f) > 0. The border of A rises over B where the line enters A, as the inside of A is on the left of the border; B's
// border rises over A where the line leaves B.
#include "query/body/flat_crossing.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "ecods/primitives.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/posed_body.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/intersection/surface_intersection.hpp"

namespace ecods {
namespace {

// A FlatSet holds the corners of a polygon in cyclic order, or points on one line.
struct FlatSet {
    std::vector<PosedPoint> corners;
    bool is_polygon = false;
};

FlatSet set_of(const Posed<MeshShape>& body) {
    const convex::Hull& hull = ConvexSolidAccess::hull(static_cast<const ConvexSolid&>(*body.what));
    const auto vertices = body.what->mesh().vertices();
    FlatSet set;
    set.is_polygon = !hull.faces.empty();
    const auto add = [&](std::uint32_t v) { set.corners.push_back({body.pose, vertices[hull.mesh_vertices[v]]}); };
    if (set.is_polygon) {
        for (const convex::Hull::Neighbor& corner : hull.cycle_of(0)) add(corner.vertex);
    } else {
        for (std::uint32_t v = 0; v < hull.vertex_count(); ++v) add(v);
    }
    return set;
}

FlatSet set_of_triangle(const Posed<MeshShape>& surface, std::uint32_t triangle) {
    const Mesh& mesh = surface.what->mesh();
    FlatSet set;
    for (const std::uint32_t v : mesh.triangles()[triangle]) set.corners.push_back({surface.pose, mesh.vertices()[v]});
    for (int axis = 0; axis < 3; ++axis) {
        set.is_polygon |= orient2d(set.corners[0], set.corners[1], set.corners[2], axis) != Sign::zero;
    }
    return set;
}

// Heights are the heights of a set's corners over the plane of a polygon, as signs.
struct Heights {
    Heights(const FlatSet& set, const FlatSet& polygon) {
        const auto& c = polygon.corners;
        for (const PosedPoint& corner : set.corners) of.push_back(orient3d(c[0], c[1], c[2], corner));
    }
    bool has(Sign sign) const noexcept { return std::ranges::find(of, sign) != of.end(); }
    bool are_on_both_sides() const noexcept { return has(Sign::negative) && has(Sign::positive); }
    std::size_t first(Sign sign) const noexcept {
        return static_cast<std::size_t>(std::ranges::find(of, sign) - of.begin());
    }

    std::vector<Sign> of;
};

bool passes_through(const FlatSet& line, const FlatSet& polygon) {
    const Heights heights(line, polygon);
    if (!heights.are_on_both_sides()) return false;
    const PosedPoint &low = line.corners[heights.first(Sign::negative)],
                     &high = line.corners[heights.first(Sign::positive)];
    const auto& c = polygon.corners;
    const Sign first = orient3d(low, high, c[0], c[1]);
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Sign sign = orient3d(low, high, c[i], c[(i + 1) % c.size()]);
        if (sign == Sign::zero || sign != first) return false;
    }
    return true;
}

// Edges are the two edges of a polygon that cross a plane: one end is above the plane, and the other one is below or in
// it.
struct Edges {
    Edges(const FlatSet& polygon, const Heights& heights) {
        const auto& c = polygon.corners;
        for (std::size_t i = 0; i < c.size(); ++i) {
            const std::size_t next = (i + 1) % c.size();
            const bool is_above = heights.of[i] == Sign::positive, ends_above = heights.of[next] == Sign::positive;
            if (!is_above && ends_above) rising = {&c[i], &c[next]};
            if (is_above && !ends_above) falling = {&c[next], &c[i]};
        }
    }

    using Edge = std::array<const PosedPoint*, 2>;
    Edge rising{}, falling{};  // named by the direction of the border; stored from the lower end
};

Sign order(const Edges::Edge& a, const Edges::Edge& b) {
    return orient3d(*a[0], *a[1], *b[0], *b[1]);
}

bool do_cross(const FlatSet& a, const FlatSet& b) {
    if (!a.is_polygon && !b.is_polygon) return false;
    if (!a.is_polygon) return passes_through(a, b);
    if (!b.is_polygon) return passes_through(b, a);
    const Heights over_b(a, b), over_a(b, a);
    if (!over_b.are_on_both_sides() || !over_a.are_on_both_sides()) return false;
    const Edges of_a(a, over_b), of_b(b, over_a);
    return order(of_a.rising, of_b.rising) == Sign::positive && order(of_a.falling, of_b.falling) == Sign::negative;
}

}  // namespace

bool is_flat_set(const Posed<MeshShape>& body) {
    if (body.what->form() != MeshForm::convex) return false;
    return ConvexSolidAccess::hull(static_cast<const ConvexSolid&>(*body.what)).is_flat() &&
           exact::is_regular(body.pose.R);
}

bool do_flat_cross(const Posed<MeshShape>& flat, const Posed<MeshShape>& other, QueryMemory& memory) {
    const FlatSet set = set_of(flat);
    if (is_flat_set(other)) return do_cross(set, set_of(other));
    const Posed<MeshShape> surface = boundary_of(other);
    std::vector<std::uint32_t> met;
    for (const TrianglePair& pair : surface::intersecting_triangles(boundary_of(flat), surface, memory)) {
        met.push_back(pair.b);
    }
    std::ranges::sort(met);
    met.erase(std::ranges::unique(met).begin(), met.end());
    return std::ranges::any_of(met, [&](std::uint32_t i) { return do_cross(set, set_of_triangle(surface, i)); });
}

}  // namespace ecods
