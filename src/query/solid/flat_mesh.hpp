// Represents flat convex sets, which are polygons, segments and points: as the hull of points in one plane, and as a
// mesh that covers the set.
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

// A FlatCycle holds the vertices of a flat convex set, as indices of points: one point, the two ends of a segment, or
// the vertices around a polygon, of which no three are on one line.
using FlatCycle = std::vector<std::uint32_t>;

// Returns the hull of the points `among`, which must be distinct; nullopt if they are not in one plane, or there are
// none. A polygon begins with its least index, and goes around counterclockwise, seen from the side to which its normal
// points if the normal's first coordinate that is not zero is positive. Exact. Cost: n log n; for points that are not
// in one plane, one or two passes.
std::optional<FlatCycle> flat_hull(std::span<const Vec3> points, std::vector<std::uint32_t> among);

// Returns a mesh of the set: a fan of triangles around the least vertex, ascending; {0, 1, 1} for a segment and {0, 0,
// 0} for a point. Its vertices keep the order of the points.
std::shared_ptr<const Mesh> mesh_of_flat(std::span<const Vec3> points, const FlatCycle& cycle);

// A FlatMesh is a flat convex set that a mesh covers. Each feature of the set is named by triangles of the mesh.
struct FlatMesh {
    FlatCycle cycle;  // in the order in which the corners of the polygon's least triangle of positive area turn
    // Lists, for each edge from cycle[k] to the next vertex, the least side of a triangle that lies on it. A point has
    // no edge.
    std::vector<SideRef> sides;
    std::uint32_t face = 0;  // the least triangle of positive area of a polygon

    bool is_polygon() const noexcept { return cycle.size() > 2; }
};

// Returns the flat convex set that the mesh covers; nullopt if the mesh covers no such set. The triangles of positive
// area must tile a convex polygon edge to edge: each side of a triangle is a side of exactly one other triangle or lies
// on the polygon's border. If no triangle has an area, the triangles must cover a segment or be one point. Exact. Cost:
// n log n for a flat mesh; some passes over the triangles for any other mesh.
std::optional<FlatMesh> find_flat(const ProperMesh& proper);

}  // namespace ecods
