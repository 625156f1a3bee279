// Flat convex sets: a polygon, a segment or a point, as the hull of points in one plane, and as a mesh that covers it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// A cycle holds the vertices of a flat convex set, as indices of points: one, the two ends of a segment, or those
// around a polygon, of which no three are on one line.
using FlatCycle = std::vector<std::uint32_t>;

// Returns the hull of the points `among`, which are distinct; nullopt if these are not in one plane, or there are none.
// A polygon goes around counterclockwise, seen from the side to which the first coordinate of its normal that is not
// zero is positive, and begins with its least index. Exact. Cost: n log n; a few points if four of the first are not in
// one plane.
std::optional<FlatCycle> flat_hull(std::span<const Vec3> points, std::vector<std::uint32_t> among);

// Returns a mesh of the set: a fan of triangles around the least vertex, ascending; {0, 1, 1} for a segment and {0, 0,
// 0} for a point. Its vertices keep the order of the points.
std::shared_ptr<const Mesh> mesh_of_flat(std::span<const Vec3> points, const FlatCycle& cycle);

// A flat convex set that a mesh covers. Each part is named by triangles of the mesh.
struct FlatMesh {
    FlatCycle cycle;  // a polygon turns as the corners of its least triangle of positive area
    // By edge, from cycle[k] to the next vertex: the least side of a triangle that lies on it. A point has none.
    std::vector<SideRef> sides;
    std::uint32_t face = 0;  // the least triangle of positive area of a polygon

    bool is_polygon() const noexcept { return cycle.size() > 2; }
};

// Returns the set if the mesh covers a flat convex one; otherwise nullopt. The triangles of positive area must tile a
// convex polygon edge to edge: each side of one is a side of exactly one other or lies on the polygon's border. If
// there are none, all triangles must cover a segment or be one point. Exact. Cost: n log n for a flat mesh; some passes
// over the triangles for another.
std::optional<FlatMesh> find_flat(const ProperMesh& proper);

}  // namespace ecods
