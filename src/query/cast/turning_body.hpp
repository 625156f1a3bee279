// TurningBody is a body that turns, as the search of a piece of its turn sees it: its places, and bounds of its size
// and its way.
#pragma once

#include <algorithm>
#include <cmath>

#include "bvh/axes/motion_axes.hpp"
#include "ecods/pose.hpp"
#include "exact/measure/contact/half_angle.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// Returns the sum of the magnitudes of the coordinates.
inline double sum_of(const Vec3& v) {
    return v.cwiseAbs().sum();
}

// Returns an upper bound of the length; where its square may overflow, the sum of magnitudes.
double length_above(const Vec3& v);

// All places are relative to the translation of the body's pose at the start.
//
// Bound. Each entry of a place is computed like a corner in turning_points.hpp, from exact numbers, or from a pivot
// that is off by u' of itself: it is off by less than u' (140 (1 + k) |sin| + 8) times the sum of magnitudes of its
// column; for the translation, these are the pivot's, times 140 (1 + k) |sin| alone, and the glide's. A leg that does
// not begin at a pose of doubles (turn_leg.hpp) adds u' / 2 of its entries, and of its translation. With the sum of
// such errors of a point, of its distance in place of its coordinates (a factor of sqrt(3)), and of the distance of
// both poses, this is less than 512 u' times the sum of magnitudes at rest and of the glide so far, and (1 + k) |sin|
// times the sum of magnitudes of what turns. About half of it is left over, for a center of the body that is posed so,
// and its distance from the other center. If both bodies turn, each adds its own.
// Claim: verify/proofs/turn_pieces.md
struct TurningBody {
    // `beside` is the distance to which rounding adds: the vector to the other body. `way_size` is the sum of the
    // magnitudes of all ways that `glide` is the difference of.
    void bind(const MeshTree& tree, const Mat3& R, const exact::TurnAngles& turn_angles, const Vec3& pivot_at_start,
              const Vec3& way, double size_of_way, const Vec3& beside);

    // Throws NotSupported beyond the limits up to which bounds in doubles exclude anything; beyond them, all pairs of
    // triangles would be decided exactly. `sizes` is that of both bodies.
    void require_moderate(double sizes) const;

    struct Place {
        Mat3 R;
        Vec3 t;
    };
    Place place_at(const exact::HalfAngle& half) const;

    // Returns the margin of points that leave their chords by `sagitta` times their distance from the axis.
    MotionMargin::Across across(double sagitta) const;
    // True if places are bounded at times at which the rotation is known.
    bool is_bounded() const noexcept { return angles->is_bounded() && size + arm + way_size < 0x1p1000; }
    // Returns what 512 u' is multiplied with to bound the places between two times.
    double rounding(const exact::HalfAngle& from, const exact::HalfAngle& to) const noexcept {
        const double condition = std::max(from.condition, to.condition);
        const double turned = (1 + condition) * std::max(std::abs(from.sin), std::abs(to.sin)) * (size + arm);
        return turned + (size + to.time * way_size);
    }

    const exact::TurnAngles* angles = nullptr;
    const Mat3* start = nullptr;  // the linear part of the pose at the start
    Vec3 pivot = Vec3::Zero(), glide = Vec3::Zero();
    Vec3 half = Vec3::Zero();  // half the size of a box around the body at the start
    double radius = 0;         // upper bound of the distance of its points from the axis
    double size = 0;           // sum of the magnitudes of the body at the start, and of the vector to the other one
    double arm = 0;            // sum of the magnitudes of the pivot
    double way_length = 0;     // upper bound of the glide's length
    double way_size = 0;
};

}  // namespace ecods
