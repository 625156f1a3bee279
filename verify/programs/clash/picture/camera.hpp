// From where a picture is taken: a parallel projection.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::clash {

// Looks along `forward` with `up` upwards: three unit vectors at right angles, right x up = -forward. What is at
// `target` comes into the middle; half_height is how much of the scene is seen above it, in its unit. The eye is at
// `distance` from the target, in front of both parts: a parallel projection is the same from anywhere, a viewer's is
// not.
struct Camera {
    Vec3 target = Vec3::Zero();
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitZ();
    Vec3 forward = Vec3::UnitY();
    double half_height = 1;
    double distance = 1;
};

// A camera at the side `to_eye` of what it looks at; `vertical` is upright in its pictures. Neither is zero, and they
// are not parallel.
Camera camera_from(const Vec3& to_eye, const Vec3& vertical);

// Half the height of the least picture of `aspect` (width by height) around the camera's target that shows all points.
double half_height_of(const Camera& camera, std::span<const Vec3> points, double aspect);

// The target in the middle of what the camera sees of the points, at a depth in the middle of theirs.
void look_at_middle(Camera& camera, std::span<const Vec3> points);

// Where a point is in a picture: x to the right and y down in pixels, z away from the eye in the same unit.
Vec3 on_screen(const Vec3& point, const Camera& camera, std::size_t width, std::size_t height);

std::array<Vec3, 8> corners_of(const Aabb& box);

}  // namespace ecods::clash
