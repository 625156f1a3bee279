// What a World answers to questions about more than two bodies (world.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "ecods/first_contact.hpp"
#include "ecods/ids.hpp"
#include "ecods/solid.hpp"
#include "ecods/triangle_hit.hpp"

namespace ecods {

// A body that is nearest to something, and two bodies that are closest to each other: by their distances, rounded once.
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

// What a segment or a ray meets of a body. `hit.rank` counts the smaller parameters of all bodies that were asked.
struct BodyHit {
    BodyId body;
    Hit hit;
};

// A body that is met by one on the move: `contact.a` is a feature of that one, `contact.b` of this body.
struct BodyContact {
    BodyId body;
    FirstContact contact;

    friend bool operator==(const BodyContact&, const BodyContact&) = default;
};

// Two bodies that meet while bodies move: `contact.a` is a feature of `bodies.a`.
struct Meeting {
    BodyPair bodies;
    FirstContact contact;

    friend bool operator==(const Meeting&, const Meeting&) = default;
};

// Two bodies that are solids and share a point, and how the first is to the second.
struct SolidPair {
    BodyPair bodies;
    SolidRelation relation = SolidRelation::touching;

    friend bool operator==(const SolidPair&, const SolidPair&) = default;
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
