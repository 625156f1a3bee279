// Ears: triangles that can be cut off a face.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"

namespace ecods::scenes {

// A closed walk from corner to corner, and a name for each corner. Places and names may repeat.
struct PlaneWalk {
    std::vector<Vec2> points;
    std::vector<std::uint32_t> names;

    std::size_t size() const noexcept { return points.size(); }
    void add(const Vec2& point, std::uint32_t name) {
        points.push_back(point);
        names.push_back(name);
    }
};

// Adds the triangles of a face. The walk has three corners at least, and goes once around an open set without holes,
// which is to the left of each edge; edges may be walked there and back. No corner lies inside an edge. All triangles
// are counter-clockwise and of positive area; they are two less than the corners. Each edge is an edge of one triangle.
// False if there is no way to go on, which happens with walks around no such set; some triangles are added then, too.
//
// Three corners in a row are an ear if they turn to the left and no other corner is in their triangle or on its third
// side. Each face has a triangulation, of which two triangles have two edges of the walk each: these are ears. Without
// an ear, the rest is a face again.
//
// Cost: a corner is tested when its neighbors change, so there are less than 3 n tests; each looks for corners in a
// tree, in O(log n) mostly and O(n) at most. The shortest ears come first, as long thin ones pass by many corners.
bool cut_ears(const PlaneWalk& face, std::vector<Triangle>& triangles);

}  // namespace ecods::scenes
