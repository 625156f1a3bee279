// The oracle's first contacts along a way of turns (include/ecods/turn.hpp), where a first contact is, and contacts in
// the gap between the end of a way and a pose: in rational numbers, all pairs of triangles, and without a tree.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "oracle/first_contact.hpp"

namespace ecods::oracle {

// A soup that turns from one quaternion to another while its pivot goes from one place to another. At its own pose the
// pivot is at `pivot`, and the quaternion 1.
struct LegSoup {
    Soup start;
    Vec3 pivot;
    std::array<double, 4> from, to;
    Vec3 pivot_from, pivot_to;
};

struct WaySoup {
    Soup start;
    std::vector<std::array<double, 4>> quaternions;
    std::vector<Vec3> pivots;

    LegSoup leg(std::size_t k) const {
        return {start, pivots[0], quaternions[k], quaternions[k + 1], pivots[k], pivots[k + 1]};
    }
};

struct ExactWayContact {
    std::size_t leg;
    ExactContact contact;
};
std::optional<ExactWayContact> first_contact(const WaySoup& a, const Soup& b);

// A point and a normal, each coordinate rounded once.
struct PlaceOfContact {
    Vec3 point;
    std::optional<Vec3> normal;
};
// Returns where these features are when their triangles first meet, which they do. Places are taken at rational times
// that are as near to the real one as 2^-5000 of it: a number that is nearer than 2^-1500 of it to a short one is taken
// for that one, and one below 2^-2400 of the largest corner for zero; quotients of doubles are below 2^2100. Where no
// corners differ much in size, a fifth of these bits is enough.
PlaceOfContact place_of_contact(const LegSoup& a, const Soup& b, const NamedFeature& of_a, const NamedFeature& of_b);
PlaceOfContact place_of_contact(const MovingSoup& a, const MovingSoup& b, const NamedFeature& of_a,
                                const NamedFeature& of_b);

// Of a, on its straight way from where the leg ends to the pose, with b.
std::optional<ExactContact> settling_contact(const LegSoup& a, const Pose& to, const Soup& b);

}  // namespace ecods::oracle
