// TurningBody computes the places of a body that turns, and upper bounds of its size and its way, for the search of a
// piece of a turn.
#pragma once

#include <algorithm>
#include <cmath>

#include "bvh/axes/motion_axes.hpp"
#include "ecods/pose.hpp"
#include "exact/measure/contact/half_angle.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// Returns the sum of the magnitudes of the coordinates of v.
inline double sum_of(const Vec3& v) {
    return v.cwiseAbs().sum();
}

// Returns an upper bound of the length of v: the sum of the magnitudes of its coordinates if the square of the length
// may overflow.
double length_above(const Vec3& v);

// All places of the body are relative to the translation of its pose at the start.
//
// Bound. Each entry of a place is computed like a corner in turning_points.hpp, from exact numbers or from a pivot that
// is off by u' of itself. An entry of the matrix is off by less than u' (140 (1 + k) |sin| + 8) times the sum of the
// magnitudes of its column. An entry of the translation is off by 140 u' (1 + k) |sin| times the sum of the pivot's
// magnitudes, and by 8 u' times that of the glide. A leg that does not begin at a pose of doubles (turn_leg.hpp) adds
// u' / 2 of the entries and of the translation.
//
// Let S be the sum of the magnitudes at rest and of the glide so far, and T the sum of the magnitudes of what turns.
// Then points are off, in distance, by less than 512 u' (S + (1 + k) |sin| T). This includes a factor of sqrt(3) from
// coordinates to distances, and the rounding of the distance of both poses. About half of the bound is left over: it
// covers the center of the body, which is posed in the same way, and the distance from the other body's center. If both
// bodies turn, each adds its own bound.
// Claim: verify/proofs/turn_pieces.md
struct TurningBody {
    // Binds the body to its turn. `way` is the glide of the pivot. `size_of_way` is the sum of the magnitudes of the
    // ways whose difference is the glide. `beside` is the vector to the other body; its size adds to rounding errors.
    void bind(const MeshTree& tree, const Mat3& R, const exact::TurnAngles& turn_angles, const Vec3& pivot_at_start,
              const Vec3& way, double size_of_way, const Vec3& beside);

    // Throws NotSupported if the turn or its size exceeds the limits of bounds in doubles. Without this error, all
    // pairs of triangles would be decided exactly. `sizes` is the size of both bodies together.
    void require_moderate(double sizes) const;

    struct Place {
        Mat3 R;
        Vec3 t;
    };
    Place place_at(const exact::HalfAngle& half) const;

    // Returns the margin of points whose distance from their chords is at most `sagitta` times their distance from the
    // axis.
    MotionMargin::Across across(double sagitta) const;
    // Returns true if the error bounds of places hold at all times at which the rotation is known.
    bool is_bounded() const noexcept { return angles->is_bounded() && size + arm + way_size < 0x1p1000; }
    // Return the factors of 512 u' in the error bound of places between two times: the factor at the first time, and
    // the number that is added to the factor at the last time.
    double rounding(const exact::HalfAngle& from, const exact::HalfAngle& to) const noexcept {
        const double condition = std::max(from.condition, to.condition);
        const double turned = (1 + condition) * std::max(std::abs(from.sin), std::abs(to.sin)) * (size + arm);
        return turned + (size + from.time * way_size);
    }
    double later(const exact::HalfAngle& from, const exact::HalfAngle& to) const noexcept {
        return (to.time - from.time) * way_size;
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
