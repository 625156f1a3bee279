// PosedPoints are N points of any bodies, by reference; RoundedPoints are such points in doubles, with an error bound.
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

// Refers to a mesh at a pose; `extent` is the mesh's.
struct BodyRef {
    const Mesh* mesh;
    const MeshExtent* extent;
    const Pose* pose;
};

// Names a body of a frame and a vertex of its mesh, by index.
struct VertexRef {
    std::size_t body;
    std::uint32_t vertex;
};

// The corners of two triangles, those of the first body's first.
constexpr std::array<VertexRef, 6> corners_of(const Triangle& a, const Triangle& b,
                                              std::size_t body_of_b = 1) noexcept {
    const std::size_t second = body_of_b;
    return {{{0, a[0]}, {0, a[1]}, {0, a[2]}, {second, b[0]}, {second, b[1]}, {second, b[2]}}};
}

// Refers to the point R v + t of a body.
struct PointRef {
    const Pose* pose;
    const Vec3* v;
};

// Points of up to N bodies; relative to the translation t0 of the first pose, each is R v + t - t0.
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

// Rounds points whose poses are all the identity, which makes no error.
template <std::size_t N>
RoundedPoints<N> plain_points(const PosedPoints<N>& exact) noexcept {
    RoundedPoints<N> result{{}, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const Vec3& v = *exact[i].v;
        result.points[i] = {v[0], v[1], v[2]};
    }
    // Covers subnormal coordinates that the processor takes for zero.
    result.delta = 0x1p-1000;
    return result;
}

}  // namespace ecods::exact
