// PosedPoints refers to N points of any bodies. RoundedPoints holds such points in doubles, with an error bound.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "exact/point/mesh_extent.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

// A BodyRef refers to a mesh, the mesh's extent and a pose.
struct BodyRef {
    const Mesh* mesh;
    const MeshExtent* extent;
    const Pose* pose;
};

// A VertexRef names a vertex by its index in a mesh, and the mesh's body by its index in a frame.
struct VertexRef {
    std::size_t body;
    std::uint32_t vertex;
};

// Returns the corners of triangle a of body 0, and then of triangle b of body `body_of_b`.
constexpr std::array<VertexRef, 6> corners_of(const Triangle& a, const Triangle& b,
                                              std::size_t body_of_b = 1) noexcept {
    const std::size_t second = body_of_b;
    return {{{0, a[0]}, {0, a[1]}, {0, a[2]}, {second, b[0]}, {second, b[1]}, {second, b[2]}}};
}

// A PointRef refers to the point R v + t of a body with the pose [R t].
struct PointRef {
    const Pose* pose;
    const Vec3* v;
};

// PosedPoints<N> holds points of any bodies. Relative to the translation t0 of the first point's pose, each is R v + t
// - t0.
template <std::size_t N>
using PosedPoints = std::array<PointRef, N>;

template <std::size_t N>
struct RoundedPoints {
    Points<N> points;
    double delta;  // upper bound of the error of every coordinate
};

template <std::size_t N>
RoundedPoints<N> round_points(const PosedPoints<N>& exact) noexcept {
    RoundedPoints<N> result{{}, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const Pose& pose = *exact[i].pose;
        const Vec3 offset = pose.t - exact[0].pose->t;
        result.points[i] = pose_point(pose.R, *exact[i].v, offset);
        result.delta = std::max(result.delta, point_error_bound(pose.R, exact[i].v->cwiseAbs(), offset));
    }
    return result;
}

// Returns the points v themselves as doubles. All poses must be the identity, so rounding makes no error.
template <std::size_t N>
RoundedPoints<N> plain_points(const PosedPoints<N>& exact) noexcept {
    RoundedPoints<N> result{{}, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const Vec3& v = *exact[i].v;
        result.points[i] = {v[0], v[1], v[2]};
    }
    // The bound 2^-1000 covers subnormal coordinates that the processor takes for zero.
    result.delta = 0x1p-1000;
    return result;
}

}  // namespace ecods::exact
