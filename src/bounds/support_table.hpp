// A SupportTable stores values of a mesh's support function, and computes the box of the posed mesh in constant time.
//
// The support function h(d) = max d . v, over the points v of a mesh relative to the center, gives the box of every
// pose. On axis i the box reaches from (R center + t)_i - h(-r_i) to (R center + t)_i + h(r_i), where r_i is row i of
// R. h is convex and positively homogeneous, so values at the corners p_k of a triangle on the surface of the unit cube
// bound it on the whole cone over that triangle:
//     d = m (l_0 p_0 + l_1 p_1 + l_2 p_2),  l_k >= 0   implies   h(d) <= m (l_0 h(p_0) + l_1 h(p_1) + l_2 h(p_2)).
// The table has h on a grid over the cube. box() also uses the oriented box of the mesh's local frame, which is tighter
// for rods and plates.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bounds/local_frame.hpp"
#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

struct SupportTableGrid {
    static constexpr int cell_count = 8;               // cells along an edge of the cube
    static constexpr int side_count = cell_count + 1;  // grid points along an edge
    static constexpr std::size_t face_size = side_count * side_count;
    // A table has h(p) and h(-p) for each axis and each grid corner p on the face of the cube where that coordinate is
    // one.
    static constexpr std::size_t direction_count = 3 * face_size * 2;
};

class SupportTable {
  public:
    // Computes the table of the mesh in its local frame. Cost: some hundred nanoseconds for each vertex. `frame` must
    // outlive the table.
    SupportTable(const Mesh& mesh, const LocalFrame& frame);

    // Returns a box that contains the exact body. On each side it is loose by at most an eighth of the mesh's half
    // diagonal, typically by far less (a ball: 1.6 % of its radius), and never looser than the oriented box. An end is
    // infinite only if it is beyond the largest double; one infinite end does not make others infinite.
    Aabb box(const Pose& pose) const;

    // Sets boxes[i] to box(poses[i]) for each i, with the same bits. Computes four boxes at a time in about half the
    // time of single ones, or eight in a quarter if the processor has AVX-512. Pointers may repeat in both lists.
    void boxes(std::span<const Pose* const> poses, std::span<Aabb* const> boxes) const;

  private:
    const LocalFrame& frame_;
    Vec3 v_max_;           // upper bounds of |coordinate|, by axis, of the center and of all points of the mesh
    double v_max_of_all_;  // the largest coordinate of v_max_
    std::array<float, SupportTableGrid::direction_count> support_;  // in units of the frame's scale
};

}  // namespace ecods
