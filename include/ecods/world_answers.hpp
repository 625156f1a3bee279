// What a World answers to questions about more than two bodies (world.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "ecods/depth.hpp"
#include "ecods/first_contact.hpp"
#include "ecods/ids.hpp"
#include "ecods/solid.hpp"
#include "ecods/triangle_hit.hpp"

namespace ecods {

// A body that is nearest to something, and two bodies that are closest to each other: those of the least distance, if
// that is at most the limit, which is decided for the real number; of equal distances, each rounded once, the least id
// or pair. Distances that differ by less than their rounding are equal here.
//
// Cost: that of BroadPhase::visit_near or visit_near_pairs; for each body or pair visited that is not filtered out a
// test of `within`, mostly a cheap one, and a distance where that is the least so far.
struct NearestBody {
    BodyId body;
    double distance = 0;

    friend bool operator==(const NearestBody&, const NearestBody&) = default;
};
struct ClosestPair {
    BodyPair bodies;
    double distance = 0;

    friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};

// What a segment or a ray meets of a body. `hit.rank` counts the smaller parameters of all bodies that were asked. In
// the order of the real parameters, then of the ids, then of the triangles; the parameters that a shape of the caller's
// own gives count as they are.
//
// Cost: that of BroadPhase::visit_along, and a question to each body whose box is met up to the first hit.
struct BodyHit {
    BodyId body;
    Hit hit;
};

// A body that is met first by one on the move, if that is at a time of at most the limit, which is decided for the real
// time; of equal times, each rounded once, the least id. `contact.a` is a feature of that one, `contact.b` of this
// body.
struct BodyContact {
    BodyId body;
    FirstContact contact;

    friend bool operator==(const BodyContact&, const BodyContact&) = default;
};

// Two bodies that meet while bodies move: `contact.a` is a feature of `bodies.a`. By first time, rounded once, then by
// pair. Pairs that meet at time 0 are among them.
//
// Cost: near-linear in the bodies listed, those that changed since the last update and the colliding pairs, and a
// question for each two bodies whose ways' boxes overlap.
struct Meeting {
    BodyPair bodies;
    FirstContact contact;

    friend bool operator==(const Meeting&, const Meeting&) = default;
};

// Two bodies that are solids and share a point, and how the first is to the second: those whose surfaces collide, and
// those of which one is inside the other.
//
// Cost: at an update one solid_relation() for each pair of solids that was tested, and a pass over the list.
struct SolidPair {
    BodyPair bodies;
    SolidRelation relation = SolidRelation::touching;

    friend bool operator==(const SolidPair&, const SolidPair&) = default;
};

// Two bodies that are convex solids and share a point, and the shortest way out: of `bodies.b`, along the direction.
//
// Cost: a pass over the bodies, sorting the boxes of convex solids into trees, and a depth() for each pair that shares
// a point.
struct BodyDepth {
    BodyPair bodies;
    Depth depth;

    friend bool operator==(const BodyDepth&, const BodyDepth&) = default;
};

// Two bodies that are convex solids, and their distance, rounded once: 0 exactly where they share a point.
//
// Cost: as of BodyDepth, and a solid_distance() for each pair whose boxes are not proven to be further apart than the
// limit.
struct SolidDistance {
    BodyPair bodies;
    double distance = 0;

    friend bool operator==(const SolidDistance&, const SolidDistance&) = default;
};

// A body that a point is in, or on.
struct BodyAt {
    BodyId body;
    Side side = Side::inside;

    friend bool operator==(const BodyAt&, const BodyAt&) = default;
};
struct BodiesContaining {
    std::vector<BodyAt> bodies;     // ascending
    std::size_t skipped_count = 0;  // bodies of the world that are no solids, and of which it is not known
};

}  // namespace ecods
