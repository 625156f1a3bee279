// What a segment or a ray shares with a triangle (hit.hpp says how to ask).
#pragma once

#include <cstdint>
#include <iosfwd>

#include "ecods/closest_points.hpp"
#include "ecods/export.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

// How a triangle is hit.
enum class HitKind : std::uint8_t {
    front,   // inside the face, coming from the side from which its posed corners are counterclockwise
    back,    // inside the face, from the other side
    face,    // inside the face, by a point that comes from no side: a segment of length 0, a ray in the face that ends
             // where it begins
    edge,    // at one point inside an edge
    vertex,  // at one point, a vertex
    along,   // at more than one point: a part of the segment lies in the triangle's plane, or on a zero-area triangle
};

ECODS_API std::ostream& operator<<(std::ostream& out, HitKind kind);

// What a segment or ray shares with one triangle: a point, or all points from `point` to `leave_point`.
struct Hit {
    double parameter = 0;        // of the first shared point
    double leave_parameter = 0;  // of the last one: the same unless `along`
    HitKind kind = HitKind::front;
    // The number of smaller real parameters at which something is hit by this question: hits of equal rank are exact
    // ties, whatever their rounded parameters.
    std::uint32_t rank = 0;
    // The feature of lowest dimension of this triangle that holds all shared points. Corners at equal coordinates are
    // one vertex; what has several names in the triangle has that of the least corner.
    Feature feature;
    Vec3 point = Vec3::Zero();  // each coordinate rounded once; a zero is +0
    Vec3 leave_point = Vec3::Zero();

    std::uint32_t triangle() const noexcept { return feature.triangle; }
};

}  // namespace ecods
