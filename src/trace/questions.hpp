// Defines the table of questions. Each question of World about many bodies that a trace holds is one row, like each
// call in calls.hpp. The first field of a row is the digest of the answer (world/answer_digest.hpp), which a replay
// compares with the digest of its own answer.
//
// `fields` passes these kinds of fields, besides the kinds of calls.hpp:
//
//     answer     the digest                             number           0 or more, infinity included
//     line       a segment or a ray                     motion, any_motion, point, optional_filter, groups
//     moved_bodies   as many bodies as motions
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/motion.hpp"
#include "ecods/primitives.hpp"
#include "trace/calls.hpp"

namespace ecods::calls {

// Holds the fields of the questions about hits of a segment or a ray.
template <class Line>
struct OfLine {
    std::uint64_t answer;
    Line line;
    std::optional<CollisionFilter> filter;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.line(call.line...);
        each.optional_filter(call.filter...);
    }
};

template <class Names>
struct FirstHit : OfLine<Segment> {
    static constexpr std::string_view name = "first_hit";
    auto ask(auto& world) const { return world.first_hit(line, filter); }
};

template <class Names>
struct FirstHitOfRay : OfLine<Ray> {
    static constexpr std::string_view name = "first_hit_of_ray";
    auto ask(auto& world) const { return world.first_hit(line, filter); }
};

template <class Names>
struct AllHits : OfLine<Segment> {
    static constexpr std::string_view name = "all_hits";
    auto ask(auto& world) const { return world.all_hits(line, filter); }
};

template <class Names>
struct AllHitsOfRay : OfLine<Ray> {
    static constexpr std::string_view name = "all_hits_of_ray";
    auto ask(auto& world) const { return world.all_hits(line, filter); }
};

// Holds the fields of questions with an upper limit of distances.
struct UpTo {
    std::uint64_t answer;
    double limit;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.number(call.limit...);
    }
};

template <class Names>
struct Cast {
    static constexpr std::string_view name = "cast";
    std::uint64_t answer;
    typename Names::Body body;
    Vec3 motion;
    double max_time;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.body(call.body...);
        each.motion(call.motion...);
        each.number(call.max_time...);
    }
    auto ask(auto& world) const { return world.cast(body, motion, max_time); }
};

template <class Names>
struct CastOf {
    static constexpr std::string_view name = "cast_of";
    std::uint64_t answer;
    typename Names::Body body;
    Motion motion;
    double max_time;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.body(call.body...);
        each.any_motion(call.motion...);
        each.number(call.max_time...);
    }
    auto ask(auto& world) const { return world.cast(body, motion, max_time); }
};

template <class Names>
struct Meetings {
    static constexpr std::string_view name = "meetings";
    std::uint64_t answer;
    typename Names::template List<typename Names::Body> bodies;
    typename Names::template List<Pose> poses;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.posed_bodies(call.bodies..., call.poses...);
    }
    auto ask(auto& world) const { return world.meetings(bodies, poses); }
};

template <class Names>
struct MeetingsOfMotions {
    static constexpr std::string_view name = "meetings_of";
    std::uint64_t answer;
    typename Names::template List<typename Names::Body> bodies;
    typename Names::template List<Motion> motions;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.moved_bodies(call.bodies..., call.motions...);
    }
    auto ask(auto& world) const { return world.meetings(bodies, motions); }
};

template <class Names>
struct Nearest {
    static constexpr std::string_view name = "nearest";
    std::uint64_t answer;
    typename Names::Body body;
    double limit;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.body(call.body...);
        each.number(call.limit...);
    }
    auto ask(auto& world) const { return world.nearest(body, limit); }
};

template <class Names>
struct ClosestOfAll : UpTo {
    static constexpr std::string_view name = "closest_pair";
    auto ask(auto& world) const { return world.closest_pair(limit); }
};

// Holds the fields of questions about the pairs of two groups of bodies.
struct OfGroups {
    std::uint64_t answer;
    double limit;
    std::uint64_t groups_a, groups_b;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.number(call.limit...);
        each.groups(call.groups_a...);
        each.groups(call.groups_b...);
    }
};

template <class Names>
struct ClosestOfGroups : OfGroups {
    static constexpr std::string_view name = "closest_pair_of";
    auto ask(auto& world) const { return world.closest_pair(limit, groups_a, groups_b); }
};

template <class Names>
struct ClosestPairs : OfGroups {
    static constexpr std::string_view name = "closest_pairs";
    auto ask(auto& world) const { return world.closest_pairs(limit, groups_a, groups_b); }
};

template <class Names>
struct BodiesAtPoint {
    static constexpr std::string_view name = "bodies_containing";
    std::uint64_t answer;
    Vec3 point;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.point(call.point...);
    }
    auto ask(auto& world) const { return world.bodies_containing(point); }
};

template <class Names>
struct Depths {
    static constexpr std::string_view name = "depths";
    std::uint64_t answer;

    static void fields(auto&& each, auto&... call) { each.answer(call.answer...); }
    auto ask(auto& world) const { return world.depths(); }
};

template <class Names>
struct SignedDistances : UpTo {
    static constexpr std::string_view name = "signed_distances";
    auto ask(auto& world) const { return world.signed_distances(limit); }
};

// This question is only read, not written: it occurs in version 1, and in version 2 before signed_distances.
// unsigned_distances() is declared where World is known.
template <class Names>
struct SolidDistances : UpTo {
    static constexpr std::string_view name = "solid_distances";
    auto ask(auto& world) const { return unsigned_distances(world, limit); }
};

template <class Names>
using Question = std::variant<FirstHit<Names>, FirstHitOfRay<Names>, AllHits<Names>, AllHitsOfRay<Names>, Cast<Names>,
                              Meetings<Names>, Nearest<Names>, ClosestOfAll<Names>, BodiesAtPoint<Names>, Depths<Names>,
                              SolidDistances<Names>, SignedDistances<Names>, ClosestOfGroups<Names>,
                              ClosestPairs<Names>, CastOf<Names>, MeetingsOfMotions<Names>>;

}  // namespace ecods::calls
