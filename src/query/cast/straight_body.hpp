// StraightBody describes a body whose points move straight while another body turns: its places, and bounds of its size
// and its way.
#pragma once

#include "ecods/pose.hpp"
#include "query/cast/turning_body.hpp"

namespace ecods {

// A StraightBody computes the place of the body at time s: an affine map whose translation is relative to that of the
// pose at the start.
//
// Bound. Let x and y be an entry of the matrix at the start and at the end. The entry at time s is computed as x (1 -
// s) + y s, off by 3.01 u' of |x| (1 - s) + |y| s. The translation is computed as s times a difference, off by 2.01 u'
// of itself. So the error is bounded as for a TurningBody (turning_body.hpp) that does not turn and has the size `size`
// + s `end_size`.
// Claim: verify/proofs/turn_pieces.md
struct StraightBody {
    // Binds the tree and the poses at both ends. `beside` is the vector to the other body; its length adds to the
    // rounding error.
    void bind(const MeshTree& tree, const Pose& at_start, const Pose& at_end, const Vec3& beside);

    TurningBody::Place place_at(double time) const { return {from->R * (1 - time) + to->R * time, time * way}; }
    // Returns true if the error bound of places holds.
    bool is_bounded() const noexcept { return size + end_size < 0x1p1000; }
    // Returns a factor: the error of the place at `time` is at most 512 u' times the result.
    double rounding(double time) const noexcept { return size + time * end_size; }

    const Pose* from = nullptr;
    const Pose* to = nullptr;
    Vec3 way = Vec3::Zero();
    Vec3 half = Vec3::Zero();  // half the sizes of a box around the body, the larger of both ends
    double least = 0;          // half the diagonal of that box at the end where it is smaller
    double size = 0;           // sum of the magnitudes of the body at the start, and of the vector to the other one
    double end_size = 0;       // sum of the magnitudes of the body at the end, and of the way
};

}  // namespace ecods
