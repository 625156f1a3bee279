// Bodies, motions and lines at which bounds in floating point are hard put: slivers, planes an ulp apart, sheets beside
// needles, coordinates that cancel, poses that are nearly singular or scale by 2^300, subnormal numbers.
#pragma once

#include <cstdint>
#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "geometry/line.hpp"
#include "scenes/random.hpp"

namespace ecods::guesses {

using scenes::Random;

// Two soups of triangles; each triangle has vertices of its own, three by three.
struct Bodies {
    std::shared_ptr<const Mesh> a, b;
    Pose pose_a, pose_b;
};

// Up to so many triangles each. All numbers are finite.
Bodies some_bodies(Random& random, std::uint32_t triangle_max);

// A point of a triangle of the mesh in the world, rounded: a corner, one on an edge or inside.
Vec3 some_point(Random& random, const Mesh& mesh, const Pose& pose);

// A translation of the first body that brings it to the second, nearly, or past it. Not zero.
Vec3 some_motion(Random& random, const Bodies& bodies);

// Where a body may be at the end of a straight motion that brings it near a point of the other.
Pose some_end(Random& random, const Pose& from, const Vec3& by);

// A segment or ray to a point of the body or near it, of any length, at times of length zero.
Line some_line(Random& random, const Mesh& mesh, const Pose& pose);

// 2^k for k from `low` to `high`.
double some_power(Random& random, int low, int high);

}  // namespace ecods::guesses
