// StraightBody is a body whose points move straight, as the search of a piece of another body's turn sees it: its
// places, and bounds of its size and its way.
#pragma once

#include "ecods/pose.hpp"
#include "query/cast/turning_body.hpp"

namespace ecods {

// All places are relative to the translation of the body's pose at the start.
//
// Bound. An entry of a place is computed as x (1 - s) + y s, off by 3.01 u' of |x| (1 - s) + |y| s, and a translation
// as s times a difference, off by 2.01 u' of itself. So places are within the bound of a TurningBody (turning_body.hpp)
// that does not turn, with all magnitudes at the start, and s times those at the end, as its size.
// Claim: verify/proofs/turn_pieces.md
struct StraightBody {
    // `beside` is the distance to which rounding adds: the vector to the other body.
    void bind(const MeshTree& tree, const Pose& at_start, const Pose& at_end, const Vec3& beside);

    TurningBody::Place place_at(double time) const { return {from->R * (1 - time) + to->R * time, time * way}; }
    // Returns true if places are bounded.
    bool is_bounded() const noexcept { return size + end_size < 0x1p1000; }
    // Returns what 512 u' is multiplied with to bound the place at a time.
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
