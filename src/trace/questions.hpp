// Defines the table of questions. Each question of World about many bodies that a trace holds is one row, like each
// call in calls.hpp. The first field of a row is the digest of the answer (world/answer_digest.hpp), which a replay
// compares with the digest of its own answer.
//
// `fields` passes these kinds of fields, besides the kinds of calls.hpp:
//
//     answer     the digest                             number           0 or more, infinity included
//     line       a segment or a ray                     motion   a vector, or a Motion
//     moved_bodies   as many bodies as poses or motions      point, optional_filter, groups
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"
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

template <class Names>
struct SidedHits : OfLine<Segment> {
    static constexpr std::string_view name = "sided_hits";
    auto ask(auto& world) const { return world.sided_hits(line, filter); }
};

template <class Names>
struct SidedHitsOfRay : OfLine<Ray> {
    static constexpr std::string_view name = "sided_hits_of_ray";
    auto ask(auto& world) const { return world.sided_hits(line, filter); }
};

template <class Names>
struct InsideParts : OfLine<Segment> {
    static constexpr std::string_view name = "inside_parts";
    auto ask(auto& world) const { return world.inside_parts(line, filter); }
};

template <class Names>
struct InsidePartsOfRay : OfLine<Ray> {
    static constexpr std::string_view name = "inside_parts_of_ray";
    auto ask(auto& world) const { return world.inside_parts(line, filter); }
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

// Holds the fields of questions about a body that moves: AnyMotion is a vector, of a translation, or a Motion.
template <class Names, class AnyMotion>
struct OfMotion {
    std::uint64_t answer;
    typename Names::Body body;
    AnyMotion motion;
    double max_time;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.body(call.body...);
        each.motion(call.motion...);
        each.number(call.max_time...);
    }
};

template <class Names>
struct Cast : OfMotion<Names, Vec3> {
    static constexpr std::string_view name = "cast";
    auto ask(auto& world) const { return world.cast(this->body, this->motion, this->max_time); }
};

template <class Names>
struct CastOf : OfMotion<Names, Motion> {
    static constexpr std::string_view name = "cast_of";
    auto ask(auto& world) const { return world.cast(this->body, this->motion, this->max_time); }
};

template <class Names>
struct Entering : OfMotion<Names, Vec3> {
    static constexpr std::string_view name = "entering";
    auto ask(auto& world) const { return world.entering(this->body, this->motion, this->max_time); }
};

template <class Names>
struct CastToDistance {
    static constexpr std::string_view name = "cast_to_distance";
    std::uint64_t answer;
    typename Names::Body body;
    Vec3 motion;
    double distance, max_time;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.body(call.body...);
        each.motion(call.motion...);
        each.number(call.distance...);
        each.number(call.max_time...);
    }
    auto ask(auto& world) const { return world.cast_to_distance(body, motion, distance, max_time); }
};

// Holds the fields of questions about bodies that all move, each to a pose or by a Motion.
template <class Names, class Way>
struct OfWays {
    std::uint64_t answer;
    typename Names::template List<typename Names::Body> bodies;
    typename Names::template List<Way> ways;

    static void fields(auto&& each, auto&... call) {
        each.answer(call.answer...);
        each.moved_bodies(call.bodies..., call.ways...);
    }
    auto ask(auto& world) const { return world.meetings(bodies, ways); }
};

template <class Names>
struct Meetings : OfWays<Names, Pose> {
    static constexpr std::string_view name = "meetings";
};

template <class Names>
struct MeetingsOfMotions : OfWays<Names, Motion> {
    static constexpr std::string_view name = "meetings_of";
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
using Question =
    std::variant<FirstHit<Names>, FirstHitOfRay<Names>, AllHits<Names>, AllHitsOfRay<Names>, Cast<Names>,
                 Meetings<Names>, Nearest<Names>, ClosestOfAll<Names>, BodiesAtPoint<Names>, Depths<Names>,
                 SolidDistances<Names>, SignedDistances<Names>, ClosestOfGroups<Names>, ClosestPairs<Names>,
                 CastOf<Names>, MeetingsOfMotions<Names>, Entering<Names>, CastToDistance<Names>, SidedHits<Names>,
                 SidedHitsOfRay<Names>, InsideParts<Names>, InsidePartsOfRay<Names>>;

}  // namespace ecods::calls
