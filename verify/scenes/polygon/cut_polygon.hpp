// Polygons in space, cut into triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

enum class PolygonCut : std::uint8_t {
    // The fan around the first corner covers the polygon once, and each of its triangles has area. Each convex polygon
    // of which no three corners are on one line is cut so. Three corners, and corners that are all on one line, are cut
    // into fans, too.
    fan,
    // Other triangles cover the polygon once.
    ears,
    // No triangles cover the polygon once: its outline crosses itself or goes round something twice, along each axis.
    // It is cut into the fan around its first corner, which may be anything.
    crossing,
};

// Cuts a polygon into triangles, which are added to the list. The corners, three at least, are indices of vertices.
//
// The cut is decided exactly, in the projection along an axis: the one along which the polygon has its largest area, or
// another one if the outline crosses itself there. For corners in one plane all of them show the same polygon. Corners
// in no plane have a surface that depends on the cut. The outline may touch itself: holes may be joined to it by edges
// there and back, corners may repeat, spikes may stick out. All corners are corners of triangles, those on a straight
// edge, too. Triangles go round as the polygon does. Each edge of the outline is the edge of one triangle; one that
// passes through another corner of the outline is cut there.
//
// Triangles have zero area only where edges of the outline bound nothing: each edge of a spike is one.
//
// Cost: one pass for a fan. Otherwise a map of the plane is made, and each of its faces cut, inside and outside of the
// outline: of 100,000 corners in 0.3 to 1.7 s (comb, spiral, star). An outline that crosses itself may be tried six
// times, in 2 to 5 s. O(n^2) where many corners are in the way of many others.
PolygonCut cut_polygon(std::span<const Vec3> vertices, std::span<const std::uint32_t> corners,
                       std::vector<Triangle>& triangles);

// Decides exactly whether the corners are in one plane. Cost: one pass.
bool is_in_a_plane(std::span<const Vec3> vertices, std::span<const std::uint32_t> corners);

}  // namespace ecods::scenes
