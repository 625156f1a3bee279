// Ears: triangles that can be cut off a face.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/predicates.hpp"

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

// Adds the triangles of a face, three corners at least: a walk once around an open set without holes, which is to the
// left of each edge; edges may be walked there and back. No corner lies inside an edge. All triangles are
// counter-clockwise and of positive area; two less than corners. Each edge is an edge of one triangle. False if there
// is no way to go on, which happens with walks around no such set; then some triangles are added, too.
//
// A triangle of three corners in a row is an ear if it is counter-clockwise, no other corner is in it or on its third
// side, and no other edge leads into it from its corners or sides. A triangulation of the face has two triangles with
// two edges of the walk each, and they are ears; without one of them, the rest is such a face.
//
// Cost: signs are looked for in a tree of the corners, and a corner that has no ear is looked at again when what is
// in its way goes. That is O(n log n) where few corners are in the way of others, and O(n^2) signs at most where they
// are.
bool cut_ears(const PlaneWalk& face, std::vector<Triangle>& triangles);

}  // namespace ecods::scenes
