// A TurnLeg is the part of a way between two nodes; a RoundedLeg is a TurnLeg in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ecods/turn.hpp"
#include "exact/measure/contact/turning_points.hpp"
#include "exact/point/mesh_extent.hpp"
#include "exact/point/point.hpp"
#include "exact/point/posed_points.hpp"

namespace ecods {

// TurnLeg describes how a body turns from one quaternion to another. `start` is the pose of the body at the start of
// its way, and `pivot` the place of the pivot at that time. During the leg the other body is translated by `motion`.
struct TurnLeg {
    Pose start;
    Vec3 pivot;
    Quaternion from, to;
    Vec3 pivot_from, pivot_to;
    Vec3 motion = Vec3::Zero();
};

// Returns the turn as a TurnLeg, which begins with the quaternion 1.
TurnLeg leg_of(const Pose& start, const Turn& turn, const Vec3& motion = Vec3::Zero());

// Returns leg `leg` of a way, from 0 to last_leg(nodes). There must be at least two nodes.
TurnLeg leg_of(const Pose& start, std::span<const WayNode> nodes, std::size_t leg);
std::size_t last_leg(std::span<const WayNode> nodes) noexcept;

// TriangleCorners refers to the three corners of a triangle of each of two meshes.
struct TriangleCorners {
    std::array<const Vec3*, 3> a, b;
};
TriangleCorners corners_of(const Mesh& a, std::uint32_t triangle_a, const Mesh& b, std::uint32_t triangle_b) noexcept;

// points_of() returns the points that TurningTriangles takes, and refers to all its arguments. Point `origin_index` is
// the world's origin.
inline constexpr std::size_t origin_index = 8;
exact::PosedPoints<11> points_of(const TurnLeg& leg, const Pose& b, const TriangleCorners& corners) noexcept;

// Returns (the pose at `time`) - `other`, for a time from 0 to 1. Each entry is rounded once; an entry that is not 0 is
// never rounded to 0. Ignores leg.motion.
Pose pose_less(const TurnLeg& leg, double time, const Pose& other);

// A RoundedLeg is a leg in doubles. At its beginning, the body that turns is at pose `a`; its points there are off by
// at most `off` on each axis. The other body is at pose `b`. Both poses are relative to the same point of the world.
// From there on the body turns from the quaternion 1 to q, whose components are rounded once. `pivot` is the place of
// the pivot at the beginning, relative to the translation of `a`; `glide` is the way of the pivot relative to the other
// body. Both are rounded once or twice.
//
// Bound. Entries of `a` are rounded once, so a point R v + t is off by at most u' / 2 of |R| |v| + |t|, and by 2^-1074
// if an entry is subnormal. A factor of u' covers the rounding of the magnitudes, too.
// Claim: verify/proofs/turn_pieces.md
struct RoundedLeg {
    Pose a, b;
    double off = 0;
    Quaternion q;
    exact::Point pivot{}, glide{};
    double way_size = 0;  // sum of the magnitudes of the pivot's way and of the other body's motion

    // Returns the turn in doubles, as TurningSide takes it: the pivot at time 0 and its way, with error bounds.
    // `angles` must outlive the result.
    exact::TurnOfPoints turn_of_points(const exact::TurnAngles& angles) const;
};
RoundedLeg round_leg(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b);
// Returns a RoundedLeg in which only `a`, `b` and `off` are set.
RoundedLeg round_beginning(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b);

}  // namespace ecods
