// Bodies of small integers, of which features meet exactly and often, and points near their corners.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

// Each coordinate from -size to size.
Vec3 lattice_point(Random& random, int size);

// Up to so many triangles of up to six vertices: shared corners, repeated ones, and triangles without area are
// frequent. Flat: z is 0.
std::shared_ptr<const Mesh> lattice_mesh(Random& random, int size, int triangles_max, bool is_flat);

// Integer combinations of the vectors: exact in double where integers are small.
Vec3 in_basis(const Vec3& v, const hard::Basis& basis);
std::shared_ptr<const Mesh> in_basis(const Mesh& mesh, const hard::Basis& basis);

// Integers from -size to size; one in some is singular, or a reflection.
Mat3 integer_entries(Random& random, int size);

// With a corner and sizes that are small integers.
std::shared_ptr<const Mesh> lattice_box(Random& random);

// A corner of the posed mesh as doubles have it, or a point of an edge or a face.
Vec3 any_corner(const Mesh& mesh, const Pose& pose, Random& random);

}  // namespace ecods::scenes
