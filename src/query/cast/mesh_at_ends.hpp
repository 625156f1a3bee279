// MeshAtEnds refers to a mesh at both ends of a straight motion: each of its points moves from its place at time 0 to
// its place at time 1 at constant speed.
#pragma once

#include "bvh/tree/moving_tree.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "geometry/same_bits.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

// Everything that the arguments of a constructor refer to must outlive this object.
struct MeshAtEnds {
    explicit MeshAtEnds(const Moving<MeshShape>& rigid)
        : start(*rigid.what, rigid.from),
          end{&start.mesh(), &start.tree.extent, &rigid.to},
          trees(start.tree.boxes),
          is_at_rest(same_bits(rigid.from, rigid.to)) {}
    // Takes a mesh that deforms. `at_end` must have the same triangles, with other vertices; `tree_at_end` must have
    // the same structure as the tree at the start.
    MeshAtEnds(const Posed<MeshShape>& at_start, const exact::BodyRef& at_end, const MeshBvh& tree_at_end)
        : start(at_start), end(at_end), trees(start.tree.boxes, tree_at_end) {}

    MeshBody start;
    exact::BodyRef end;
    TreeAtEnds trees;
    // `is_at_rest` is true if the poses at both ends are equal, and false for a mesh that deforms. The bits of the
    // poses are compared, because a processor that flushes subnormal numbers compares two different ones as equal.
    bool is_at_rest = false;
};

}  // namespace ecods
