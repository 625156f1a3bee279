// MeshAtEnds refers to a mesh at both ends of a straight motion: each of its points moves from its place at time 0 to
// its place at time 1 at constant speed.
#pragma once

#include "base/arithmetic.hpp"
#include "bvh/tree/moving_tree.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "geometry/same_bits.hpp"
#include "query/cast/straight_move.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

// A MeshAtEnds refers to the objects that the arguments of its constructor refer to; these objects must outlive it.
struct MeshAtEnds {
    explicit MeshAtEnds(const Moving<MeshShape>& rigid)
        : start(*rigid.what, rigid.from),
          end{&start.mesh(), &start.tree.extent, &rigid.to},
          trees(start.tree.boxes),
          is_at_rest(same_bits(rigid.from, rigid.to)) {}
    // Takes a body that goes to a pose or is translated. `rounded_end` must be move.rounded_end().
    MeshAtEnds(const StraightMove& move, const Pose& rounded_end) : MeshAtEnds(move.body) {
        end.pose = &rounded_end;
        if (!move.translation) return;
        translation = &*move.translation;
        end_off = two_u * rounded_end.t.cwiseAbs().maxCoeff() + 0x1p-1000;
        is_at_rest = false;
    }
    // Takes a mesh that deforms. `at_end` must have the same triangles, with other vertices; `tree_at_end` must have
    // the same structure as the tree at the start.
    MeshAtEnds(const Posed<MeshShape>& at_start, const exact::BodyRef& at_end, const MeshBvh& tree_at_end)
        : start(at_start), end(at_end), trees(start.tree.boxes, tree_at_end) {}

    MeshBody start;
    exact::BodyRef end;
    TreeAtEnds trees;
    // `translation` is the vector by which a translated body goes from its start; it is null for a body that goes to
    // its pose at the end. At time 1, a translated body differs from its pose at the end by at most `end_off` on each
    // axis, since the sum is rounded once, or lost below 2^-1022.
    // Claim: verify/proofs/turn_pieces.md
    const Vec3* translation = nullptr;
    double end_off = 0;
    // `is_at_rest` is true if the body has equal poses at both ends, and false for a translated body and for a mesh
    // that deforms. The bits of the poses are compared, because a processor that flushes subnormal numbers compares two
    // different ones as equal.
    bool is_at_rest = false;
};

}  // namespace ecods
