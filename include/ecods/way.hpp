// A Way is a path of turns (turn.hpp) without gaps: a body that stays rigid goes from node to node. Casts along a way
// find when the body first shares a point with another one. No World is needed.
//
//     const Way way(link, pose, {{{1, 0, 0, 0}, hinge}, {{0, 0, 0, 1}, hinge}, {{-1, 0, 0, 0}, hinge}});
//     if (auto met = cast(way, {wall, Pose()})) met->leg, met->contact.time
//
// Each node has a quaternion and a place of the pivot. The way from one node to the next is a leg, which takes a time s
// from 0 to 1. With z0 and z1 the quaternions of its nodes, c0 and c1 the places of the pivot there, and c the place of
// the pivot at the first node, the point that is at p at the beginning is at
//
//     x = c0 + s (c1 - c0) + R (p - c),     R the rotation of the quaternion (1 - s) z0 + s z1,
//
// as real numbers; a quaternion of any length is a rotation (turn.hpp has the formula). So quaternions are those of the
// turn since the beginning, not since the last node; the body is exactly rigid all the way; and one leg begins exactly
// where the one before it ends. Neither errors nor the cost of a leg grow with the number of nodes. The first node's
// quaternion is a positive number w, usually 1, so that the body begins at its pose. A way of two nodes, {1, from} and
// {q, to}, is the Turn {q, from, to}.
//
// A leg turns the short way about one axis, by less than half a turn if z0 . z1 > 0, and up to a whole one otherwise: z
// and -z are the same place, but another way there. So a whole turn takes two legs, as in the example above; more of
// them take more. A factor on a node's quaternion changes the speed, not the way; of equal lengths, half the time of a
// leg is half its angle.
//
// Example: verify/examples/how_do_i, turn_all_the_way().
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/motion.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// A Way is a thing that is at a pose at the first of the nodes, and then goes along them. It has copies of pose and
// nodes, and refers to or keeps the thing as Posed does.
template <class T>
struct Way {
    Way(const T& thing, const Pose& start, std::vector<WayNode> along)
        : what(&thing), pose(start), nodes(std::move(along)) {}
    Way(const T&& thing, const Pose& start, std::vector<WayNode> along) = delete;  // a temporary, which would be gone

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Way(std::shared_ptr<Derived> thing, const Pose& start, std::vector<WayNode> along)
        : what(thing.get()), pose(start), nodes(std::move(along)), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    const T* what;  // never null
    Pose pose;
    std::vector<WayNode> nodes;
    std::shared_ptr<const T> kept;  // null where the thing is referred to
};

template <class T>
Way(std::shared_ptr<T>, const Pose&, std::vector<WayNode>) -> Way<std::remove_const_t<T>>;

// A WayContact is the first contact on a way; leg 0 goes from node 0 to node 1.
struct WayContact {
    std::size_t leg = 0;
    FirstContact contact;  // its time is that in the leg, rounded once

    friend bool operator==(const WayContact&, const WayContact&) = default;
};

// Returns the first contact of a with b, which stays; nullopt if there is none on any leg. Decided for the real
// numbers, as cast.hpp says. A contact at a node is the last one of the leg that ends there, at its time 1, so a leg
// begins with a contact at time 0 on leg 0 only. A time that rounds to 1 belongs to the leg in which the real time is.
// To stop earlier, leave nodes out. contact_point() (contact.hpp) has the point and the normal.
//
// Starts from a witness, and leaves the triangles that decided. Throws what validate() throws; NotSupported as cast()
// of a Turning does, if a leg is such a turn and there is no contact before it. Cost: that of a cast of a Turning for
// each leg up to the contact; the exact decision of two triangles takes a few times as long as that of a Turn, since
// two quaternions have more digits than one.
[[nodiscard]] ECODS_API std::optional<WayContact> cast(const Way<MeshShape>& a, const Posed<MeshShape>& b,
                                                       const Ask& ask = {});

// Returns settle() of turn.hpp from the end of the last leg.
[[nodiscard]] ECODS_API std::optional<FirstContact> settle(const Way<MeshShape>& a, const Pose& to,
                                                           const Posed<MeshShape>& b, const Ask& ask = {});

// Returns the pose at a time of a leg, from 0 to 1, each entry rounded once. Throws InvalidArgument; also if there is
// no such leg (Argument::turn, "nodes").
[[nodiscard]] ECODS_API Pose pose_at(const Pose& pose, std::span<const WayNode> nodes, std::size_t leg, double time);

}  // namespace ecods
