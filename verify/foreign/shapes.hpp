// The shapes that others test with, and the questions that they ask of them.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"

namespace ecods::foreign {

inline constexpr double pi = std::numbers::pi;

inline ConvexSolid hull_of(const std::vector<Vec3>& points) {
    return ConvexSolid(std::span<const Vec3>(points));
}

// The corners of the box from `low` to `high`.
inline std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
                             (i & 4) != 0 ? high[2] : low[2]);
    }
    return corners;
}

// The box around the origin, of these half sides.
inline ConvexSolid box(const Vec3& half) {
    return hull_of(box_corners(-half, half));
}

inline MeshShape triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return MeshShape(Mesh::create({a, b, c}, {{0, 1, 2}}));
}
inline MeshShape point(const Vec3& p) {
    return MeshShape(Mesh::create({p}, {{0, 0, 0}}));
}

// One mesh of two that do not meet.
inline std::shared_ptr<const Mesh> both(const Mesh& mesh, const Pose& a, const Pose& b) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Pose* pose : {&a, &b}) {
        const auto offset = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3& v : mesh.vertices()) vertices.push_back(pose->R * v + pose->t);
        for (const Triangle& t : mesh.triangles()) triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

inline Pose at(double x, double y, double z) {
    return {Mat3::Identity(), Vec3(x, y, z)};
}
inline Mat3 turn(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// A pose by the twelve numbers of its first three rows.
inline Pose pose_of(const std::array<double, 12>& m) {
    Pose pose;
    pose.R << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    pose.t << m[3], m[7], m[11];
    return pose;
}

// The distance of two convex solids, or less the depth if they share a point, as others call it.
inline double signed_number(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) {
    return signed_distance(a, b).distance;
}

inline constexpr std::array<std::array<std::size_t, 3>, 6> orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

// The closest points; nothing if the solids share a point.
inline std::optional<ClosestPoints> closest_apart(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) {
    const ClosestPoints points = closest(a, b);
    return points.kind < ClosestKind::intersecting ? std::optional(points) : std::nullopt;
}

}  // namespace ecods::foreign
