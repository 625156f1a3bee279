// A Turn (pose.hpp) is a motion of a body that stays rigid: it turns about an axis while a pivot moves on a straight
// line. Casts of turning bodies find when they first share a point with others. (FCL: InterpMotion, ScrewMotion; Parry:
// cast_shapes_nonlinear.) No World is needed.
//
//     const Turn turn = about({0, 0, 1}, 0.5, hinge);
//     if (auto contact = cast({door, pose, turn}, {wall, Pose()})) angle_at(turn, contact->time)
//
// With c = pivot_from and m = pivot_to - pivot_from, as real numbers, and q = (w, v), the point that is at p at time 0
// is, at a time s from 0 to 1, at
//
//     x = c + s m + R (p - c),     R the rotation of the quaternion (a, b) = 1 + s (q - 1) = (1 + s (w - 1), s v),
//
// which is of any length: R g = g + 2 (a b x g + b x (b x g)) / (a a + b.b). So the body is exactly rigid at every
// time, whatever the doubles are: it starts at R v + t of its pose, and turns about the axis v through the pivot,
// counterclockwise seen against v. A hinge or the joint of a robot has both pivots equal; if the pivots differ, the
// body also glides, by m in all.
//
// The quaternion is never normalised, so its components may be rounded. Components that are multiples of 2^-30 make the
// exact decisions faster, and turn by an angle that is about 2^-30 off. A factor on q changes the speed, not the way.
//
// Angle and time. At time s the body has turned by 2 atan2(s |v|, 1 + s (w - 1)); in all by 2 atan2(|v|, w), which is
// below a whole turn: half a turn has w = 0, more has w < 0, and -q is the other way round. The angle increases with
// time. If |q| = 1, half the time is half the angle, and the speed varies by 17 % over a quarter of a turn, twice over
// half a turn. angle_at() and time_at() convert.
//
// A turn ends at the rotation q R of the start's matrix R, which is rarely a matrix of doubles. The end is therefore
// about 2^-53 of the body's size away from any pose in doubles; end_gap() bounds that distance. Before a body moves on
// from such a pose, settle() says whether the gap between is free. A Way of several turns has no gaps.
//
// The first time at which a turning body, or one that moves from pose to pose, is within a distance of another one has
// no call: it is a root of a polynomial of degree 6, and first contacts are roots of lower degrees.
//
// Example: verify/examples/how_do_i, turn_past_a_post().
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
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Return the first contact of a, which turns, with b, which stays, or is translated by time times `motion_of_b`;
// nullopt if there is none up to max_time. Bodies, time 0, max_time, grazing contact, rounding, witnesses and errors
// are as cast.hpp says, for x(s) as above; poses may be any. Also throws what validate() throws for the turn.
//
// Cost: the way is searched in several straight pieces, the more the nearer the bodies are to each other. Mostly this
// costs less than twice as much as the cast of one straight move. The exact decision of two triangles, usually one in a
// cast, takes some tenths of a millisecond. Throw NotSupported where no bound in doubles holds, so that all pairs would
// have to be decided exactly: for a turn within some 2^-28 of a whole one; |v| below 2^-500, or |v| or |w| above 2^500;
// and a pivot or glide above 2^500 times as large as the bodies.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Posed<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Vec3& motion_of_b,
                                                         const Posed<MeshShape>& b, double max_time = 1,
                                                         const Ask& ask = {});

// Returns the first contact of two bodies that both turn, each by a turn of its own; nullopt if there is none up to
// max_time. All is as for one body that turns. Bodies that move as one (their quaternions are equal, their pivots glide
// alike, and both pivots are on one axis) keep their distance, so they meet at time 0 or never.
//
// Cost: some two or three times as much as if one of them turned. The motion of each body is compared with a straight
// one, not the motion of one relative to the other; so bodies that move nearly as one, very near to each other, take
// several times as many pieces. The exact decision of two triangles takes about a millisecond. Throws what the casts of
// one turn throw, for either body.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Turning<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});

// Returns the first contact of two bodies that each move in any way, as the casts above and those of cast.hpp do; a
// straight motion may also be beside a turn or a translation. If b turns or goes along nodes and a does not, and
// several pairs of features tie, the first is chosen as if b came first. Throws the errors of the casts above, and
// NotSupported for nodes of a way (Along) beside a body that moves. Cost: that of the cast of these motions. A straight
// motion beside a turn takes about as long as two turns; beside a translation, or for two translations, as long as two
// straight motions.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Motion& motion_of_a,
                                                         const Posed<MeshShape>& b, const Motion& motion_of_b,
                                                         double max_time = 1, const Ask& ask = {});

// Returns the turn by `angle` (in radians, counterclockwise seen against the axis) about the axis through the pivot,
// which stays. The axis may have any length. q has the length 1, each component rounded once, so axis and angle are off
// by about 2^-53. Throws InvalidArgument (Argument::turn) if the axis is zero ("axis"), a number is not finite
// ("axis(0)", "pivot(0)", "angle"), or |angle| is 2 pi or more ("angle").
[[nodiscard]] ECODS_API Turn about(const Vec3& axis, double angle, const Vec3& pivot);

// Returns the turn, the short way, of a body that goes from one pose to another, in which the point `pivot_in_body` of
// the body goes straight. The numbers of the turn are rounded, so it ends near `to`, at a distance that end_gap()
// bounds. The matrices should differ by a rotation alone; if they do not, the turn does not end near `to`. Throws
// InvalidArgument if a number is not finite, or if the matrices do not differ by something like a rotation and a
// factor: one of them mirrors and the other does not, shears or is singular (Argument::pose).
[[nodiscard]] ECODS_API Turn between(const Pose& from, const Pose& to, const Vec3& pivot_in_body);

// Returns the pose at a time of a body that starts at `pose`, each entry rounded once (a number that is not 0 is never
// rounded to 0): to show it, or to go on from it. Throws InvalidArgument; also if the time is not from 0 to 1.
[[nodiscard]] ECODS_API Pose pose_at(const Pose& pose, const Turn& turn, double time);

// Return the angle in radians, from 0 to below 2 pi, by which a body has turned at a time from 0 to 1; and the time at
// which it has turned by an angle that it reaches. For an angle above that at time 1, the time is 1; so it is for a
// turn that only glides, if the angle is positive. Both are rounded once, so they increase monotonically and are equal
// on every machine. Cost: some tens of microseconds. Throw InvalidArgument; also if the time is not from 0 to 1, or the
// angle is negative or NaN (Argument::time; Argument::turn, "angle").
[[nodiscard]] ECODS_API double angle_at(const Turn& turn, double time);
[[nodiscard]] ECODS_API double time_at(const Turn& turn, double angle);

// Returns the first contact of a with b while each vertex of a moves straight from its real place at the end of the
// turn to its place at the pose `to`; nullopt if there is none. Call it after a cast() without contact, before the body
// moves on from `to`: then the body has met nothing on the turn and in the gap. The time, from 0 to 1, is that on this
// straight way, exact as in cast.hpp. Only triangles are tested, since the cast has shown that no part of a is inside b
// at the end of the turn. If triangles share a point there, the time is 0. The call is needed only if the bodies may be
// nearer to each other than end_gap() at the end; if they are not, it costs about as much as intersects(). Makes new
// scratch memory each time. Throws InvalidArgument.
[[nodiscard]] ECODS_API std::optional<FirstContact> settle(const Turning<MeshShape>& a, const Pose& to,
                                                           const Posed<MeshShape>& b, const Ask& ask = {});

// Returns an upper bound, over all vertices of the shape, of the distance of a vertex's place at the end of the turn
// that starts at `from` from its place at the pose `to`. The bound is usually some 2^-53 of the shape's size if the
// turn is between(from, to, ...). Throws InvalidArgument. Cost: a pass over the vertices.
[[nodiscard]] ECODS_API double end_gap(const MeshShape& shape, const Pose& from, const Turn& turn, const Pose& to);

// ---- ways of turns

// A Way is a path of turns without gaps: a body that stays rigid goes from node to node. Casts along a way find when
// the body first shares a point with another one. No World is needed.
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
// as real numbers; a quaternion of any length is a rotation (the formula is above). So quaternions are those of the
// turn since the beginning, not since the last node; the body is exactly rigid all the way; and one leg begins exactly
// where the leg before it ends. Neither errors nor the cost of a leg grow with the number of nodes. The first node's
// quaternion is a positive number w, usually 1, so that the body begins at its pose. A way of two nodes, {1, from} and
// {q, to}, is the Turn {q, from, to}.
//
// A leg turns the short way about one axis, by less than half a turn if z0 . z1 > 0, and by up to a whole turn
// otherwise: z and -z are the same place, but another way to get there. A whole turn takes two legs, as in the example
// above; k whole turns take 2k. A factor on a node's quaternion changes the speed, not the path. If the quaternions of
// both nodes have equal lengths, the leg has turned by half its angle at s = 1/2.
//
// Example: verify/examples/how_do_i, turn_all_the_way().

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

// Returns the first contact of a with b, which stays; nullopt if there is none on any leg. Real numbers decide, as
// cast.hpp says. A contact at a node is the last contact of the leg that ends there, at its time 1, so a leg begins
// with a contact at time 0 on leg 0 only. A time that rounds to 1 belongs to the leg in which the real time is. To stop
// earlier, leave nodes out. contact_point() (contact.hpp) has the point and the normal.
//
// Starts from a witness, and leaves the triangles that decided. Throws what validate() throws; NotSupported as cast()
// of a Turning does, if a leg is such a turn and there is no contact before it. Cost: that of a cast of a Turning for
// each leg up to the contact; the exact decision of two triangles takes a few times as long as that of a Turn, since
// two quaternions have more digits than one.
[[nodiscard]] ECODS_API std::optional<WayContact> cast(const Way<MeshShape>& a, const Posed<MeshShape>& b,
                                                       const Ask& ask = {});

// Returns the first contact of a with b while a moves straight from its place at the end of the last leg to the pose
// `to`, as settle() of a Turning does; nullopt if there is none.
[[nodiscard]] ECODS_API std::optional<FirstContact> settle(const Way<MeshShape>& a, const Pose& to,
                                                           const Posed<MeshShape>& b, const Ask& ask = {});

// Returns the pose at a time, from 0 to 1, of a leg; each entry is rounded once. Throws InvalidArgument; also if there
// is no such leg (Argument::turn, "nodes").
[[nodiscard]] ECODS_API Pose pose_at(const Pose& pose, std::span<const WayNode> nodes, std::size_t leg, double time);

}  // namespace ecods
