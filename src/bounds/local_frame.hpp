// A LocalFrame is a coordinate system of a mesh. The boxes of the mesh's tree are axis-aligned in it.
#pragma once

#include <array>

#include "ecods/mesh.hpp"

namespace ecods {

// A point v of the mesh has coordinates y with v = center + map y, exactly. The columns of `map` are orthogonal up to
// rounding, and each has the length `scale`, up to rounding. |y_k| <= 1 on each axis k for every point of the mesh.
struct LocalFrame {
    Mat3 axes = Mat3::Identity();  // map / scale
    Mat3 map = Mat3::Identity();
    Vec3 center = Vec3::Zero();
    Vec3 map_size = Vec3::Ones();  // |map| (1, 1, 1), where |map| has the absolute values
    double size_max = 1;           // the largest of 1, |map_ij| and |center_i|
    double scale = 1;              // length of the columns of map: a power of two
    Vec3 half = Vec3::Ones();      // oriented box: |y_k| <= half_k for every point of the mesh
    bool is_bounded = true;        // false if coordinates are too large for a frame; then every box is infinite

    // coordinates(v) returns the coordinates y of a point v of the mesh, as defined above, with an error of at most
    // coordinate_error on each axis.
    Mat3 inverse = Mat3::Identity();
    Vec3 coordinates(const Vec3& v) const { return inverse * (v - center); }
};

// Bounds the error of y = inverse * (v - center) as computed, on each axis, in any rounding mode. Let F = map / scale,
// and let |F^T F - I| <= tau entry by entry. A point v of the mesh has |F^T (v - center)| <= scale on each axis, so |v
// - center| <= 1.01 sqrt(3) scale. With u' = 2^-52, the difference has a relative error of u', and products and sums
// have 3.01 u', relative to at most 1.01 sqrt(3): together below 8 u'. Besides, inverse = F^T / scale is not exactly
// the inverse of map: F^-1 - F^T = (I - F^T F) F^-1 has entries below 3.1 tau, which adds 3 * 3.1 tau * 1.01 sqrt(3) <
// 16.3 tau. Underflow in the difference is harmless, because the scale is at least 2^-900. The total is below 2^-43.
// Claim: verify/proofs/small_bounds.py
inline constexpr double frame_tau_max = 0x1p-48;  // |F^T F - I|, entry by entry
inline constexpr double coordinate_error = 0x1p-43;

// Fits a frame to the mesh. Its axes are the principal axes of the triangles if the box along the principal axes has at
// most nine tenths of the surface of the box along the coordinate axes; otherwise they are the coordinate axes. Cost:
// one pass over the mesh.
LocalFrame fit_frame(const Mesh& mesh);

// Returns a frame with the axes of `frame`, fitted to the mesh after its vertices changed. Cost: one pass over the
// mesh.
LocalFrame refit_frame(const LocalFrame& frame, const Mesh& mesh);

}  // namespace ecods
