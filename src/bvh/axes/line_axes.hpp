// A line and a posed tree on three axes, for any affine pose: which boxes and triangles of a node may share a point
// with it, and from which parameter on.
//
// The axes N are those of separating_axes.hpp, the normals of the faces of the tree's own boxes or, where a pose makes
// them too flat, the axes of the world; in the coordinates N x boxes contain what they contain, and what is a line
// stays one. A point of the body is R (center + map y) + t, a point of the line a + s d. They are one where
//     X + s D = P y,    X = N ((a - t) - R center),  D = N d,  P = N R map,
// and P is the identity but for rounding where the axes are the tree's own.
//
// The part of the line that is within the root's box along the axis on which D is largest, from s0 to s1, is placed in
// doubles: it is o + r e for 0 <= r <= 1, s = s0 + r (s1 - s0), e = (s1 - s0) D, and is no longer than the box. From
// there on all is done in floats, with r.
//
// Bound, in doubles, for each axis; u' = 2^-52 bounds one operation in any rounding mode. With w = |N| (|a - t| + |R|
// |center|), X is off by 8 u' w: u' |a - t| for the difference, 3.01 u' |R| |center| for the product, u' of both for
// their difference, 3.01 u' for N. D is off by |N| |error of d| + 3.01 u' |N| |d|. Let D_m be the largest, rho the
// error of D, by axis, over |D_m|, and F = |X_m| + 4 (5 reaches in general), so |s D_m| <= F for all s that count: s
// times the error of D is at most rho F. The ends s0 and s1 are off by 4 u', that is by 4 u' F on the axis m, and the
// box was made larger by more. o and e are off by 4 u' (|X| + F). P is off by 6.1 u' |N| |R| |map|, and by e = |P - I|
// where it is taken for the identity.
//
// Floats, v = 2^-23. Boxes are within [-1, 1], e is at most 2.1 and o at most 3.2, all times 3 where P is no identity
// (rows of P are then at most 3). Numbers are converted: v each. Coordinates of e that are below 2^-30 are replaced by
// that. A box [c - h, c + h] with the margin m, which has all errors, is met from t - q to t + q, t = (c - o) / e and q
// = (h + m) / |e|: on the axis, that is in r times e, t is off by 3.01 v |c - o| <= 13 v, q by 3.01 v 1.2, their sum by
// v 2.1 where it lies within [0, 1] and matters. Projected boxes have another 4.01 v 3 for center and reach. Together
// with the conversions, 7 v, that is below 40 v, 140 v for three times the size; 96 v and 400 v are in the margin.
//
// Triangles are seen along the line: with g = o + r e for some r, p = corner - g, and slopes k = e_x / e_z and e_y /
// e_z for the axis z on which e is largest, (p_x - k p_z, p_y - k' p_z) is a point of the plane, in which the line is
// zero. For corners there is an error of corner_error (5.1 v 3 where P is no identity), 14 v for the place of the
// line, 7.5 v for p; twice these, since |k| <= 1, 2.3 v for what the slopes leave, and 23 v for products and sums: with
// `side` = 2 (error + corner) + 80 v, times four in general, each coordinate is off by less. Of two such points, of
// size E, the area is off by B = 4 E side + 2 side^2 + 4 v E^2. These areas are the weights w of the corners in the
// point where the line crosses the triangle's plane: their sum is off by 3 B + 2 v sum |w|, and is not zero where the
// line is not parallel to the plane. That point is beyond the parameter T where sum w (z - T) has the sign of sum w, z
// being corners' parameters r, off by `depth`: this sum is off by 3 B (|z| + T + depth) + sum |w| (depth + 4.1 v (|z| +
// T)). Where coordinates of e were replaced and e is below 2^-7, the slopes say where points of the line may be, but
// not which planes are parallel to it.
//
// Where all three weights certainly have one sign, the line crosses the face, at T = sum w z / sum w for the real
// weights and parameters, which is between the z: with far = max |z|, |sum w (z - T)| for the computed ones is at most
// 6 B (far + depth) + sum |w| depth, and the quotient is off by that over |sum w|, 7 v sum |w| far / |sum w| for
// products, sums and the quotient, and 4 v (far + r) for adding the r where z is 0. The line is hit there within its
// ends if T is between 2^-16 and 1 - 2^-16: s = s0 + T (s1 - s0), which rounding changes by 3 u', is less than s1 then.
//
// A box of the world: differences from t are off by u' of themselves, their mean and half their difference by 3 u' |x -
// t| together, which is added to the half; N and what is of the tree as above. Within 4 of zero, floats are off by 4 v
// for converting, 5 v for the difference of centers and 6 v for the sum of halves; a point by 4 v. 64 v are added.
//
// Underflow: as in separating_axes.hpp, factors are below 2^900; floats that matter are above 2^-60.
#pragma once

#include <array>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"
#include "geometry/scaled_line.hpp"

namespace ecods {

// The part of a line that is about as long as a tree, on the tree's axes, in floats: origin + r direction, 0 <= r <= 1.
struct LinePart {
    std::array<float, 3> origin;
    std::array<float, 3> direction;     // none is zero
    std::array<float, 3> inverse;       // of the direction
    std::array<float, 3> inverse_size;  // |inverse|
    std::array<float, 3> margin;        // added to the reach of boxes
    // Triangles are seen along the direction, in the plane of two axes.
    std::size_t x, y, z;
    float slope_x, slope_y;
    float side;   // the error of a coordinate there
    float depth;  // and of r, along the axis z
    // Whether these slopes are the line's, and not only such that no point of it is lost.
    bool has_slopes;
    // The map of the tree's coordinates to the axes, where it is no identity, by columns; and |p|.
    bool is_unit;
    std::array<std::array<float, 3>, 3> p, size;
};

// A box of the world on the axes: its points are within `half` of `center`, the errors of the nodes' boxes and of
// floats included; a point of it in floats, at(), is off by less than `error`.
struct BoxOnAxes {
    std::array<float, 3> center, half;
    float error;
};

class LineAxes {
  public:
    // What does not depend on the line.
    void bind(const MeshBvh& tree, const Pose& pose);

    enum class Place {
        apart,    // no point of the line is a point of the body
        placed,   // part() is all of the line that matters
        unknown,  // doubles cannot place the line: every triangle may be hit
    };
    // Up to the scaled parameter `limit`.
    Place place(const ScaledLine& line, double limit);

    const LinePart& part() const noexcept { return part_; }

    // Sets where a box of the world is, and returns true; or returns false where that is not known well, or the axes
    // are not the tree's own. The box counts even if the tree is elsewhere.
    bool place_box(const Vec3& low, const Vec3& high, BoxOnAxes& box) const noexcept;

    // A point of a box that is placed.
    std::array<float, 3> at(const Vec3& point) const noexcept;

    // Whether points of these r, as floats have it, are certainly within the line's ends; and the scaled parameters
    // that contain theirs.
    bool is_within(float low, float high) const noexcept {
        return has_ends_ && low >= 0x1p-16f && high <= 1 - 0x1p-16f;
    }
    double parameter_below(float ratio) const noexcept { return (begin_ + ratio * length_) * (1 - 0x1p-48); }
    double parameter_above(float ratio) const noexcept { return (begin_ + ratio * length_) * (1 + 0x1p-48); }

    // r of points whose scaled parameter is at most `parameter` is not above it.
    float ratio_above(double parameter) const noexcept;

  private:
    struct Axes {
        std::array<std::array<double, 3>, 3> N, N_size;  // by rows
        std::array<double, 3> origin;                    // t + R center, the terms
        std::array<double, 3> t, origin_size;
        std::array<double, 3> own_error;     // of P y
        std::array<double, 3> center, half;  // of the root's box
        double factor;
        bool is_bounded;
        bool is_unit;
    };

    // The part from o to o + e, whose coordinates are off by `error`, in floats.
    void set_part(const std::array<double, 3>& o, const std::array<double, 3>& e,
                  const std::array<double, 3>& error) noexcept;

    Axes axes_;
    LinePart part_;
    double begin_ = 0, length_ = 0;  // s0, s1 - s0
    bool has_ends_ = false;          // whether s1 is certainly not beyond the line's end, and no s between underflows
};

}  // namespace ecods
