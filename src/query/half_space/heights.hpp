// Computes heights of points above the plane of a posed half space: by doubles with a proven bound, and exactly.
//
// Let the half space be { x : n . x <= d } at the pose x -> R x + t, and s the sign of det R. Let C be the cofactors of
// R: det R times the inverse transposed. The image of the half space is { y : N . (y - t) <= E }, N = s C n, E = s det
// R d. So the height of a body's point R' v + t' is
//
//     h(v) = M . v + c,    M = R'^T N,    c = N . (t' - t) - E,
//
// which is |N| times the signed distance from the plane. It is a polynomial in the given doubles.
//
// Bound. u' = 2^-52 bounds one operation in any rounding mode; fused operations only leave out roundings. Each term of
// the polynomial goes through these roundings: C 2 (a product, a difference); N 3 more for a product and two sums, so
// 5; M 8; M . v 11; t' - t 1, N . (t' - t) 9; det R 5, E 6; c 10; h 12. So h is off by less than 12.1 u' times the sum
// of the magnitudes of all terms. That sum is computed in the same order from magnitudes, which has a relative error of
// 12.1 u', and subtracting the bound from h rounds once more: 16 u' covers all of it. For the boxes of the mesh's tree,
// v = center + map y with |y| <= 2 on each axis: P = M map has 11 roundings, P . y 14, M . center + c 12, the sum and
// the difference of both ends of a box 16, the margin one: 24 u' times the sum of magnitudes. Corners of leaves are off
// by corner_error on each axis, so heights by corner_error times |P| (1, 1, 1); a factor of 1.01 covers the roundings
// of this product.
//
// If no given number, and no coordinate, exceeds 2^100, nothing overflows: no term has more than five factors, or is
// greater than 2^500, and there are fewer than 2^10. An operation that underflows, or takes a subnormal number for
// zero, loses less than 2^-1021, which four more factors and 2^10 terms make less than 2^-600.
//
// The length |N| is off by the length of the errors of N, which is at most 5.01 u' |sizes of N|, and 3 u' of itself for
// the sum of squares and 0.6 u' for the root; times d, 8 u' (|N| + |sizes of N|) d covers it. Squares that underflow
// lose less than 2^-1020 together, and the root less than 2^-510.
// Claim: verify/proofs/plane_heights.py
#pragma once

#include <array>
#include <optional>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/solid.hpp"
#include "exact/number/long_vector.hpp"

namespace ecods::half_spaces {

// HeightBounds are a lower and an upper bound of a height; infinite if doubles are not precise enough.
struct HeightBounds {
    double low, high;
};

// A Plane is the plane of a posed half space: N and E, by doubles and exactly.
class Plane {
  public:
    // Computes the plane of the posed half space. Throws SingularPose with the number `argument` if the pose is
    // singular.
    explicit Plane(const Posed<HalfSpace>& posed, int argument = 1);

    struct Exact {
        exact::ScaledLongVector N;
        exact::ScaledInteger E;
        exact::ScaledInteger square;  // N . N
    };
    const Exact& exact() const;  // computed on first use

    // Returns N . (point - t) - E.
    exact::ScaledInteger height(const Vec3& point) const;
    // Returns N . vector.
    exact::ScaledInteger along(const Vec3& vector) const;

    // Returns bounds of |N| d, for d >= 0.
    HeightBounds times_length(double d) const noexcept;

  private:
    friend class Heights;

    const HalfSpace& half_space_;
    Pose pose_;
    int orientation_;  // the sign of det R
    Vec3 N_, N_size_;
    double E_, E_size_;
    bool is_moderate_;  // true if no number exceeds 2^100
    mutable std::optional<Exact> exact_;
};

// Heights computes the heights of the points of a posed body. `plane` must outlive this object.
class Heights {
  public:
    // A Side selects heights above the plane, or their negatives, the depths below the plane.
    enum class Side : signed char { above = 1, below = -1 };
    Heights(const Plane& plane, const Pose& body, Side side = Side::above);

    HeightBounds bounds(const Vec3& v) const noexcept;
    exact::ScaledInteger exact(const Vec3& v) const;
    int sign(const Vec3& v) const;  // decided by the bounds, otherwise exactly

    const Plane& plane() const noexcept { return plane_; }

  private:
    friend class BoxHeights;

    struct Exact {
        exact::ScaledLongVector M;
        exact::ScaledInteger c;
    };

    const Plane& plane_;
    Pose body_;
    double side_;
    Vec3 M_, M_size_;
    double c_, c_size_;
    bool is_moderate_;
    mutable std::optional<Exact> exact_;
};

// BoxHeights bounds the heights of the boxes of a body's tree, which must outlive this object.
class BoxHeights {
  public:
    BoxHeights(const Heights& heights, const MeshBvh& tree) noexcept;

    const MeshBvh& tree() const noexcept { return tree_; }

    // Returns a lower bound of the heights of a box with this center and half size; -infinity or NaN if doubles prove
    // no bound.
    double low(const std::array<float, 3>& center, const std::array<float, 3>& half) const noexcept {
        return below(center[0], center[1], center[2], half[0], half[1], half[2]);
    }
    // Return the set of children, or of triangles, that may have a point at a height of at most `limit`.
    std::uint32_t lanes_below(const BvhNode& node, double limit) const noexcept;
    std::uint32_t lanes_below(const TreeLeaf& leaf, double limit) const noexcept;

  private:
    double below(double x, double y, double z, double half_x, double half_y, double half_z) const noexcept {
        const double middle = ((P_[0] * x + P_[1] * y) + P_[2] * z) + q_;
        const double reach = (P_size_[0] * half_x + P_size_[1] * half_y) + P_size_[2] * half_z;
        return (middle - reach) - margin_;
    }

    const MeshBvh& tree_;
    std::array<double, 3> P_, P_size_;  // P_size_ is |P_|
    double q_, margin_, corner_margin_;
};

}  // namespace ecods::half_spaces
