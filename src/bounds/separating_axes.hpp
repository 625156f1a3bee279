// Certain disjointness of two posed boxes, for any two affine poses.
//
// Whatever vector n is taken for an axis, exact disjointness of the projections on n proves that the boxes are
// disjoint: n itself needs no accuracy, only the projections need a bound. The axes here are the columns of the two
// matrices: for rotations, the face normals of the boxes. A zero column never separates.
//
// Coordinates are relative to the first body's translation: the first box is R_a c_a + R_a [-h_a, h_a], the second
// R_b c_b + R_b [-h_b, h_b] + d. On an axis n the projections are disjoint exactly when
//     |P_a c_a - P_b c_b - n d|  >  |P_a| h_a + |P_b| h_b,      P_j = n . (column j of R).
//
// Bound, with u' = 2^-52 for one operation in any rounding mode, W = sum |n_i||R_ij| v_max_j for each body, where v_max
// bounds the coordinates of all of the mesh (hence |c_j| and h_j), and N = sum |n_i||d_i|:
//     P_j is off by 3.01 u' sum |n_i||R_ij|, so P c and |P| h are each off by 6.03 u' W; n d, with d a rounded
//     difference of translations, by 4.01 u' N; the left side adds two roundings of terms up to W_a + W_b + N, the
//     right one rounding of terms up to W_a + W_b. In sum below 16 u' (W_a + W_b + N). The margin is twice that, which
//     covers its own evaluation.
// Underflow: some 40 operations lose 2^-1022 each, times a factor of at most f = max(|n|, |R|, v_max, |d|), and
// subnormal inputs that the processor takes for zero as much times f^2: below 2^-1000 (1 + f)^2 in sum. Overflow and
// NaN make a comparison false: not certainly disjoint.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/environment.hpp"
#include "ecods/pose.hpp"

namespace ecods {

class SeparatingAxes {
  public:
    SeparatingAxes() = default;

    // `v_max`: bounds of the coordinates of the meshes that the boxes are of. `d`: fl(t_b - t_a).
    SeparatingAxes(const Mat3& Ra, const Vec3& v_max_a, const Mat3& Rb, const Vec3& v_max_b, const Vec3& d) {
        const double factor = std::max({Ra.cwiseAbs().maxCoeff(), Rb.cwiseAbs().maxCoeff(), v_max_a.maxCoeff(),
                                        v_max_b.maxCoeff(), d.cwiseAbs().maxCoeff()});
        const double underflow = 0x1p-1000 * (1 + factor) * (1 + factor);
        for (int i = 0; i < 6; ++i) {
            const Vec3 n = i < 3 ? Ra.col(i) : Rb.col(i - 3);
            const Vec3 size = n.cwiseAbs();
            Axis& axis = axes_[static_cast<std::size_t>(i)];
            axis.a = Ra.transpose() * n;
            axis.b = Rb.transpose() * n;
            axis.offset = n.dot(d);
            const double weight = (Ra.cwiseAbs().transpose() * size).dot(v_max_a) +
                                  (Rb.cwiseAbs().transpose() * size).dot(v_max_b) + size.dot(d.cwiseAbs());
            axis.margin = 32 * two_u * weight + underflow;
        }
    }

    // True only if the boxes are disjoint.
    bool separate(const Vec3& center_a, const Vec3& half_a, const Vec3& center_b, const Vec3& half_b) const {
        for (const Axis& axis : axes_) {
            const double distance = std::abs(axis.a.dot(center_a) - axis.b.dot(center_b) - axis.offset);
            const double reach = axis.a.cwiseAbs().dot(half_a) + axis.b.cwiseAbs().dot(half_b);
            if (distance > reach + axis.margin) return true;
        }
        return false;
    }

  private:
    struct Axis {
        Vec3 a;  // P_a
        Vec3 b;  // P_b
        double offset;
        double margin;
    };

    std::array<Axis, 6> axes_;
};

}  // namespace ecods
