// A LocalFrame defines coordinates of a mesh in which the boxes of its tree are axis-aligned.
#pragma once

#include <array>

#include "ecods/mesh.hpp"

namespace ecods {

// Coordinates y of a point of the mesh are defined by point = center + map y, exactly. The columns of `map` are
// orthogonal up to rounding and have one length, a power of two. |y| <= 1 on each axis for every point of the mesh.
struct LocalFrame {
    Mat3 axes = Mat3::Identity();  // map / scale
    Mat3 map = Mat3::Identity();
    Vec3 center = Vec3::Zero();
    Vec3 map_size = Vec3::Ones();  // |map| (1, 1, 1)
    double size_max = 1;           // the largest of 1, |map| and |center|
    double scale = 1;              // a power of two
    Vec3 half = Vec3::Ones();      // |y| <= half for every point: the oriented box
    bool is_bounded = true;        // false: coordinates too large for a frame; every box is infinite

    // Returns the coordinates of v, with an error of at most coordinate_error on each axis.
    Mat3 inverse = Mat3::Identity();
    Vec3 coordinates(const Vec3& v) const { return inverse * (v - center); }
};

// Bounds the error of y = inverse * (v - center) as computed, on each axis, in any rounding mode. Let F = map / scale,
// and |F^T F - I| <= tau entry by entry. A point of the mesh has |F^T (v - center)| <= scale on each axis, so
// |v - center| <= 1.01 sqrt(3) scale. With u' = 2^-52, the difference has an error of u', products and sums one of 3.01
// u', relative to at most 1.01 sqrt(3): below 8 u'. inverse = F^T / scale is not the inverse of map:
// F^-1 - F^T = (I - F^T F) F^-1 has entries below 3.1 tau, which adds 3 * 3.1 tau * 1.01 sqrt(3) < 16.3 tau. Underflow
// in the difference is harmless: the scale is at least 2^-900. The total is below 2^-43.
// Claim: verify/proofs/small_bounds.py
inline constexpr double frame_tau_max = 0x1p-48;  // |F^T F - I|, entry by entry
inline constexpr double coordinate_error = 0x1p-43;

// Fits a frame to the mesh: along the principal axes of the triangles if that box has at most nine tenths of the
// surface of the box along the coordinate axes, otherwise along the coordinate axes. Cost: one pass.
LocalFrame fit_frame(const Mesh& mesh);

// Returns a frame with the same axes for other vertices of the same mesh. Cost: one pass.
LocalFrame refit_frame(const LocalFrame& frame, const Mesh& mesh);

}  // namespace ecods
