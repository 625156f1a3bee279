// Parts whose faces lie in one plane but for the rounding of their poses, and flat ones in the plane z = 0: what
// filters leave open for every pair of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "ecods/mesh.hpp"
#include "scenes/mesh_pairs.hpp"

namespace ecods::scenes {

// A box of 2 x 2 x 2 `height` around the origin. Its upper and lower face are cut in cells x cells squares of two
// triangles, and each other one in `cells` rectangles. 4 cells^2 + 8 cells triangles.
std::shared_ptr<const Mesh> plate(std::uint32_t cells, double height);

// Two copies of the plate under one random rotation, the second on top of the first, moved aside by up to three halves
// of its size. Its translation is rounded, so that they touch, cross or miss each other by an ulp: each about as often.
MeshPairs flush_plates(const std::string& name, std::uint32_t cells, double height, std::size_t count,
                       std::uint32_t seed);

// A convex polygon with this even number of corners in the plane z = 0, cut in a zigzag. corners - 2 triangles.
std::shared_ptr<const Mesh> flat_polygon(std::uint32_t corners);

// Two copies of it, each turned about z, with a gap or depth of 1e-4 to 1e-2 of their radius; every other query hits.
MeshPairs flat_polygons(std::uint32_t corners, std::size_t count, std::uint32_t seed);

// A mesh of one triangle.
std::shared_ptr<const Mesh> one_triangle();

}  // namespace ecods::scenes
