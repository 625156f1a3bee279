// A TurnLeg is the part of a way between two nodes, exactly and as doubles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ecods/turn.hpp"
#include "ecods/way.hpp"
#include "exact/point/mesh_extent.hpp"
#include "exact/point/point.hpp"
#include "exact/point/posed_points.hpp"

namespace ecods {

// Says how a body turns from one quaternion to another. `start` is its pose at the start of the way, and `pivot` the
// place of the pivot then. Meanwhile the other body is translated by `motion`.
struct TurnLeg {
    Pose start;
    Vec3 pivot;
    Quaternion from, to;
    Vec3 pivot_from, pivot_to;
    Vec3 motion = Vec3::Zero();
};

// A turn is a leg that begins at 1.
TurnLeg leg_of(const Pose& start, const Turn& turn, const Vec3& motion = Vec3::Zero());

// Returns a leg of a way, from 0 to last_leg(). There must be at least two nodes.
TurnLeg leg_of(const Pose& start, std::span<const WayNode> nodes, std::size_t leg);
std::size_t last_leg(std::span<const WayNode> nodes) noexcept;

// Names three vertices of each of two meshes.
struct TriangleCorners {
    std::array<const Vec3*, 3> a, b;
};
TriangleCorners corners_of(const Mesh& a, std::uint32_t triangle_a, const Mesh& b, std::uint32_t triangle_b) noexcept;

// Returns the points that TurningTriangles takes; number `origin_index` is the world's origin. Refers to all arguments.
inline constexpr std::size_t origin_index = 8;
exact::PosedPoints<11> points_of(const TurnLeg& leg, const Pose& b, const TriangleCorners& corners) noexcept;

// Returns the pose at a time from 0 to 1 minus `other`, each entry rounded once; an entry that is not 0 is never
// rounded to 0. The other body's motion does not matter.
Pose pose_less(const TurnLeg& leg, double time, const Pose& other);

// A leg in doubles. At its beginning, points of the body that turns are at those of pose `a`, off by at most `off` on
// each axis, and the other body is at pose `b`; both poses are relative to the same point of the world. From there on
// the body turns from 1 to q, each component rounded once. `pivot` is its place at the beginning, relative to the
// translation of `a`, and `glide` its way beside the other body, each rounded once or twice.
//
// Bound. Entries of `a` are rounded once, so a point R v + t is off by u' / 2 of |R| |v| + |t| at most, and 2^-1074 if
// an entry is subnormal; u' covers that the magnitudes are rounded.
// Claim: verify/proofs/turn_pieces.md
struct RoundedLeg {
    Pose a, b;
    double off = 0;
    Quaternion q;
    exact::Point pivot{}, glide{};
    double way_size = 0;  // sum of magnitudes of both ways
};
RoundedLeg round_leg(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b);
// Returns the same without the turn and the pivot: both poses, and `off`.
RoundedLeg round_beginning(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b);

}  // namespace ecods
