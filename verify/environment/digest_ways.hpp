// Digests of what a line hits of a triangle, and of when triangles on their way meet.
#pragma once

#include <cstdint>

#include "exact/point/frame.hpp"
#include "geometry/line.hpp"

namespace ecods::environment {

std::uint64_t digest_of_hit(std::uint64_t digest, const Line& line, const exact::BodyRef& body);

// The motion is not zero.
std::uint64_t digest_of_translation(std::uint64_t digest, const exact::BodyRef& a, const Vec3& motion,
                                    const exact::BodyRef& b);

// They share no point at the start.
std::uint64_t digest_of_motion(std::uint64_t digest, const exact::BodyRef& a, const Pose& to_a, const exact::BodyRef& b,
                               const Pose& to_b);

}  // namespace ecods::environment
