// LineAxes projects a line and a posed tree to three axes, for any affine pose. So kernels find which boxes and
// triangles of a node may share a point with the line, and from which parameter on.
//
// The axes N are chosen as in separating_axes.hpp: the normals of the faces of the tree's own boxes or, if a pose makes
// these too flat, the axes of the world. The map x -> N x maps lines to lines, and a box contains the same points after
// it. A point of the body is R (center + map y) + t, and a point of the line is a + s d. They are equal if
//     X + s D = P y,    X = N ((a - t) - R center),  D = N d,  P = N R map,
// and P is the identity, up to rounding, if the axes are the tree's own.
//
// Let s0 and s1 be the ends of the part of the line that is within the root's box on the axis on which D is largest.
// The part is computed in doubles: it is o + r e for 0 <= r <= 1, with s = s0 + r (s1 - s0) and e = (s1 - s0) D, and
// on that axis it is no longer than the box. All further computations are in floats, with the parameter r.
//
// Bound, in doubles, for each axis; u' = 2^-52 bounds one operation in any rounding mode. Let w = |N| (|a - t| + |R|
// |center|). X is off by 8 u' w: u' |a - t| for the difference, 3.01 u' |R| |center| for the product, u' of both for
// their difference, 3.01 u' for N. D is off by |N| |error of d| + 3.01 u' |N| |d|. Let D_m be the largest |D|, rho the
// error of D, by axis, over |D_m|, and F = |X_m| + 4 (5 reaches in general), so |s D_m| <= F for all s that matter.
// Then s times the error of D is at most rho F. The ends s0 and s1 are off by 4 u', that is by 4 u' F on the axis m,
// and the box was made larger by more. o and e are off by 4 u' (|X| + F). P is off by 6.1 u' |N| |R| |map|, and by e =
// |P - I| if it is taken for the identity.
//
// Floats, v = 2^-23. Boxes are within [-1, 1], e is at most 2.1 and o at most 3.2, all times 3 if P is not the identity
// (rows of P are then at most 3). Converting a number costs v. Coordinates of e that are below 2^-30 are replaced by
// 2^-30. A box [c - h, c + h] has the margin m, which contains all errors. The line meets it from t - q to t + q, where
// t = (c - o) / e and q = (h + m) / |e|. On the axis, that is in r times e, t is off by 3.01 v |c - o| <= 13 v, q by
// 3.01 v 1.2, and their sum by v 2.1 if it lies within [0, 1] and matters. Projected boxes have another 4.01 v 3 for
// center and reach. Together with the conversions, 7 v, that is below 40 v, or 140 v for three times the size; 96 v and
// 400 v are in the margin.
//
// Triangles are projected along the line to a plane. Let g = o + r e for some r, p = corner - g, z the axis on which e
// is largest, k = e_x / e_z and k' = e_y / e_z. Then (p_x - k p_z, p_y - k' p_z) is the projection of the corner, and
// the projection of the line is 0. A corner has corner_error (5.1 v 3 if P is not the identity), the position of the
// line 14 v and p 7.5 v. These count twice, since |k| <= 1. Rounding the slopes adds 2.3 v, products and sums 23 v. So
// with `side` = 2 (error + corner) + 80 v, times four in general, each coordinate is off by less than `side`. The area
// (cross product) of two projected corners, of size E, is off by B = 4 E side + 2 side^2 + 4 v E^2. These areas are the
// weights w of the corners in the point where the line crosses the triangle's plane. Their sum is off by 3 B + 2 v sum
// |w|, and is not zero if the line is not parallel to the plane. That point is beyond the parameter T if sum w (z - T)
// has the sign of sum w, where z are the corners' parameters r, off by `depth`. The sum of w (z - T) is off by 3 B (|z|
// + T + depth) + sum |w| (depth + 4.1 v (|z| + T)). If coordinates of e were replaced and e is below 2^-7, the slopes
// show where points of the line may be, but not which planes are parallel to it.
//
// If all three weights certainly have one sign, the line crosses the face, at T = sum w z / sum w for the real weights
// and parameters, which is between the z. With far = max |z|, |sum w (z - T)| for the computed numbers is at most 6 B
// (far + depth) + sum |w| depth. The quotient is off by this bound divided by |sum w|, by 7 v sum |w| far / |sum w| for
// products, sums and the quotient, and by 4 v (far + r) for adding the r at which z is 0. The crossing is within the
// line's ends if T is between 2^-16 and 1 - 2^-16: then s = s0 + T (s1 - s0), which rounding changes by 3 u', is less
// than s1.
//
// Boxes of the world. A difference x - t is off by u' of itself. The center and the half, computed from two such
// differences, are off by 3 u' |x - t| together, which is added to the half. N and the tree's numbers are bounded as
// above. Within 4 of zero, floats are off by 4 v for converting, 5 v for the difference of centers and 6 v for the sum
// of halves; a point is off by 4 v. 64 v are added.
//
// Underflow: as in separating_axes.hpp, factors are below 2^900; floats that matter are above 2^-60.
#pragma once

#include <array>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"
#include "geometry/scaled_line.hpp"

namespace ecods {

// Holds a part of a line that is about as long as a tree, on the tree's axes, in floats: origin + r direction, 0 <= r
// <= 1.
struct LinePart {
    std::array<float, 3> origin;
    std::array<float, 3> direction;     // no coordinate is zero
    std::array<float, 3> inverse;       // 1 / direction
    std::array<float, 3> inverse_size;  // |inverse|
    std::array<float, 3> margin;        // added to the reach of boxes
    // Triangles are projected along the direction to the plane of the axes x and y. On axis z the direction is largest.
    std::size_t x, y, z;
    float slope_x, slope_y;
    float side;   // error bound of a coordinate in that plane
    float depth;  // error bound of r, along the axis z
    // `has_slopes` is true if the slopes are the line's own. If coordinates of the direction were replaced, the slopes
    // may be used only for bounds.
    bool has_slopes;
    // is_unit is true if the map of the tree's coordinates to the axes is the identity. Otherwise p is that map, by
    // columns, and `size` is |p|.
    bool is_unit;
    std::array<std::array<float, 3>, 3> p, size;
};

// Holds a box of the world on the axes: all its points are within `half` of `center`, where `half` includes the errors
// of the nodes' boxes and of floats. A point that at() returns in floats is off by less than `error`.
struct BoxOnAxes {
    std::array<float, 3> center, half;
    float error;
};

class LineAxes {
  public:
    // Binds a posed tree: computes all numbers that do not depend on the line.
    void bind(const MeshBvh& tree, const Pose& pose);

    enum class Place {
        apart,    // the line and the body share no point
        placed,   // part() contains all points of the line that may matter
        unknown,  // doubles are not precise enough: any triangle may be hit
    };
    // Sets part() for the points of the line up to the scaled parameter `limit`.
    Place place(const ScaledLine& line, double limit);

    const LinePart& part() const noexcept { return part_; }

    // Sets `box` to the box from `low` to `high` on the axes, and returns true. Returns false if its position is not
    // known precisely enough, or the axes are not the tree's own. The box may be anywhere relative to the tree.
    bool place_box(const Vec3& low, const Vec3& high, BoxOnAxes& box) const noexcept;

    // Returns `point` on the axes, in floats. The point must be in a box that place_box() has placed.
    std::array<float, 3> at(const Vec3& point) const noexcept;

    // is_within() is true if all points whose computed parameter r of the part is in [low, high] are certainly within
    // the line's ends. parameter_below() and parameter_above() are a lower and an upper bound of the scaled parameter
    // of a point whose computed r is `ratio`.
    bool is_within(float low, float high) const noexcept {
        return has_ends_ && low >= 0x1p-16f && high <= 1 - 0x1p-16f;
    }
    double parameter_below(float ratio) const noexcept { return (begin_ + ratio * length_) * (1 - 0x1p-48); }
    double parameter_above(float ratio) const noexcept { return (begin_ + ratio * length_) * (1 + 0x1p-48); }

    // Returns an upper bound of the parameter r of part() for all points whose scaled parameter is at most `parameter`.
    float ratio_above(double parameter) const noexcept;

  private:
    struct Axes {
        std::array<std::array<double, 3>, 3> N, N_size;  // by rows
        std::array<double, 3> origin;                    // R center
        std::array<double, 3> t, origin_size;
        std::array<double, 3> own_error;     // error of P y
        std::array<double, 3> center, half;  // the root's box
        double factor;
        bool is_bounded;
        bool is_unit;
    };

    // Sets part_ to the part from o to o + e, rounded to floats. `error` bounds the errors of its coordinates, by axis.
    void set_part(const std::array<double, 3>& o, const std::array<double, 3>& e,
                  const std::array<double, 3>& error) noexcept;

    Axes axes_;
    LinePart part_;
    double begin_ = 0, length_ = 0;  // s0 and s1 - s0
    bool has_ends_ = false;  // true if s1 is certainly not beyond the line's end, and no s in [s0, s1] underflows
};

}  // namespace ecods
