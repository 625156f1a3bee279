// find_meeting_place() computes the point that two features of moving triangles share when they first meet, and the
// normal along which the features come together, for any kind of motion.
//
// Let s be the time: a root of a polynomial p of degree 3 at most. Coordinates of the point are quotients of
// polynomials at s, and those of a normal quotients of a polynomial f and the root of a sum of squares, L. Each is
// rounded by comparing it with binary fractions m: its sign is that of f, and its square is compared by the sign of f^2
// - m^2 L, whose degree may be up to 6. A polynomial has the same value at s as its remainder by p, so only polynomials
// of degree 2 at most are evaluated there, exactly (Root::sign_of).
//
// Point. If one of the features is a vertex, the point is this vertex. If they are edges, from y along b and along a,
// they cross at y + t b with t = T0 / (T0 - T1), where T0 and T1 are the same coordinate of the turns of b's ends about
// a. A coordinate with T0 = T1 is of no use; on some coordinate T0 and T1 differ, since a x b is not zero.
//
// Normal. The turns of a corner about the three edges of a face add up to the face's normal, and T1 - T0 is a x b. The
// sign of the volume of the four corners just before s decides between the two directions of the normal; it follows
// from the volume's first derivative that is not zero at s.
#pragma once

#include <array>
#include <optional>

#include "ecods/pose.hpp"
#include "exact/measure/contact/relative_position.hpp"
#include "exact/measure/distance/feature_pair.hpp"

namespace ecods::exact {

// SecondCorners holds the corners of the second triangle, in units of 2^unit: polynomials of degree 1 at most. It also
// holds the factor of all polynomials of the RelativePosition, of degree 2 at most.
struct SecondCorners {
    std::array<RelativePosition::Vector, 3> at;
    Polynomial factor;
    int unit = 0;
};

struct MeetingPlace {
    Vec3 point;                  // each coordinate rounded once
    std::optional<Vec3> normal;  // from the first to the second triangle; only for a vertex and a face, or two edges
};

// Returns the point and the normal of the meeting of these features; nullopt if they share no point at a time that
// rounds to `time`, or if the polynomial that would have this time as a root is zero at all times.
std::optional<MeetingPlace> find_meeting_place(RelativePosition& triangles, const SecondCorners& second,
                                               const FeaturePair& features, double time);

}  // namespace ecods::exact
