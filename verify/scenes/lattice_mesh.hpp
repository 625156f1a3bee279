// Meshes on the integer lattice, and how they come to be posed meshes of doubles.
#pragma once

#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/cells.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

struct LatticeMesh {
    std::vector<LatticePoint> vertices;
    std::vector<Triangle> triangles;

    std::uint32_t add(const LatticePoint& vertex);
    void add(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r);
    void add(const LatticeMesh& other);
};

// Of a box whose corners are these, and of a tetrahedron.
LatticeMesh box(const LatticePoint& min, const LatticePoint& max);
LatticeMesh tetrahedron(const std::array<LatticePoint, 4>& corners);

// The border of a set of cells: of each unit face between a cell and none two triangles with a random diagonal. With
// `merges_faces` random rectangles of unit faces that look the same way are one face each: long edges then face several
// short ones.
LatticeMesh boundary(const Cells& cells, bool merges_faces, Random& random);

// The other order of triangles and of their corners; vertices that are equal may become different ones, and zeros
// negative.
void shuffle(std::vector<Vec3>& vertices, std::vector<Triangle>& triangles, Random& random);

// The largest coordinate of lattice points that every LatticeMap maps exactly.
inline constexpr int lattice_max = 64;

// Some triangles without area: segments between vertices, points, and three points in a row beyond two vertices, if
// these are not beyond lattice_max: rounded, they would be in a row no more, and the mesh would be open.
void add_zero_area(LatticeMesh& mesh, Random& random);

// From lattice points x to points M x + o, exactly in doubles for |x_i| <= lattice_max, and for halves of them: numbers
// of M are multiples of 2^-44 and at most 1 (or integers up to 3), and |o_i| <= 20, so that |(M x + o)_i| < 2^8, and
// half a multiple of 2^-44 below 2^8 has 53 bits.
struct LatticeMap {
    Mat3 M = Mat3::Identity();
    Vec3 o = Vec3::Zero();

    Vec3 operator()(const LatticePoint& x) const { return M * Vec3(x[0], x[1], x[2]) + o; }
};

// A regular one: a signed permutation, small integers, or numbers of 40 bits whose columns may be of different sizes.
// Half of them reflect.
LatticeMap random_map(Random& random);
// The columns of one are multiples of one vector or of two.
LatticeMap singular_map(Random& random);

struct PosedMesh {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
};

// The image of the mesh times 2^exponent, shuffled. Which part of the map is the pose and which is in the coordinates
// is chosen at random, and where the mesh's origin is. Throws std::logic_error where a coordinate is beyond
// lattice_max.
PosedMesh place(const LatticeMesh& mesh, const LatticeMap& map, int exponent, Random& random);

// In one and the same pose, which need not map the lattice exactly.
PosedMesh place_at(const LatticeMesh& mesh, const Pose& pose, Random& random);

}  // namespace ecods::scenes
