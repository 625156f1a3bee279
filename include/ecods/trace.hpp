// A trace records the calls that changed a World, and replay() runs them again. A bug report is a file.
//
// World::trace_to starts the record, with the bodies that are in the world at that moment. From then on every call that
// changed something is written, one line each, in the order of the calls. A call that threw changed nothing and is not
// written. Numbers are written without loss. The text, version 2:
//
//     ecods-trace 2
//     world sweep_and_prune 0                   broad phase; places for bodies that were used before
//     mesh 1 4 2                                number, vertices, triangles; then these:
//     v 0x0p+0 0x1.8p+1 -0x1p-1074
//     t 0 1 2
//     solid 3 4 4                               written as a mesh; the shape is a Solid
//     convex 4 4 4                              the same, a ConvexSolid
//     half_space 5 0x0p+0 0x0p+0 0x1p+0 0x0p+0  number, normal, offset
//     shape 2 7 any text                        number, kind, and the text that the caller's writer returned
//     rounded 6 4 0x1p-1                        number, number of the core, radius
//     create 1.0 1 R R R t R R R t R R R t      body, mesh or shape, pose: [R t] row by row, hexadecimal
//     create_with 2.0 1 R ... t 1 f 2a          the same; then groups, mask and user data, hexadecimal
//     destroy 1.0
//     set_pose 1.0 R R R t R R R t R R R t
//     set_poses 2                               number of lines p that follow: p, body, pose
//     p 1.0 R R R t R R R t R R R t
//     set_shape 1.0 2
//     set_filter 1.0 1 ffffffffffffffff         groups, mask; hexadecimal
//     set_pair_enabled 1.0 2.0 0                0: off, 1: on
//     set_user_data 1.0 2a                      hexadecimal
//     set_clearance 0x1.8p-3                    or none
//     set_relations 1                           0: not listed, 1: listed
//     update 0123456789abcdef 5                 digest, colliding pairs
//     note any text
//
// and, where questions are written (TraceOptions), with the digest of the answer first:
//
//     first_hit 0123456789abcdef A A A B B B none      a segment; a filter: groups, mask, or none
//     first_hit_of_ray 0123456789abcdef O O O D D D inf none
//     all_hits, all_hits_of_ray, sided_hits, sided_hits_of_ray, inside_parts, inside_parts_of_ray     the same
//     cast 0123456789abcdef 1.0 M M M 0x1p+0           body, motion, limit of time
//     entering                                         the same
//     cast_to_distance 0123456789abcdef 1.0 M M M 0x1p-1 0x1p+0       body, motion, distance, limit of time
//     meetings 0123456789abcdef 2                      number of lines p that follow, as for set_poses
//     cast_of 0123456789abcdef 1.0 translated M M M 0x1p+0            any motion; other ones are:
//     cast_of 0123456789abcdef 1.0 straight R R R t R R R t R R R t 0x1p+0
//     cast_of 0123456789abcdef 1.0 turned W X Y Z C C C D D D 0x1p+0  quaternion, both places of the pivot
//     cast_of 0123456789abcdef 1.0 along 2 W X Y Z C C C W X Y Z D D D 0x1p+0   number of nodes, then each of them
//     meetings_of 0123456789abcdef 1                   number of lines that follow: m, body, any motion
//     m 1.0 translated M M M
//     nearest 0123456789abcdef 1.0 inf                 body, limit of distance
//     closest_pair 0123456789abcdef inf
//     closest_pair_of 0123456789abcdef inf 1 2         limit of distance, groups; hexadecimal
//     closest_pairs 0123456789abcdef inf 1 2           the same
//     bodies_containing 0123456789abcdef P P P
//     depths 0123456789abcdef
//     signed_distances 0123456789abcdef inf            limit of distance
//
// A body is written as slot and generation. "update" is written before the update runs, and its result after it: if a
// program crashes in an update, the trace ends with "update" alone. An update that threw is "update failed". Lines end
// with LF; a file whose first line ends with CR LF, as some editors write it, is read as well, and a byte order mark at
// its beginning is passed over. In version 1, which is read and replayed with its old meaning, solids met as their
// surfaces did, set_solids listed relations of solids alone, and solid_distances had the distances of convex solids,
// without signs. reserve() is not written: it changes no answer. set_test cannot be, and leaves a note.
//
// Example: verify/examples/how_do_i, trace_and_replay().
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/broad_phase.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/shape.hpp"
#include "ecods/world.hpp"

namespace ecods {

struct ReplayOptions {
    std::optional<BroadPhaseKind> broad_phase = {};  // used instead of the trace's, if set
    std::shared_ptr<Executor> executor = nullptr;
    bool checks_invariants = false;  // if true, calls World::check_invariants() after each update

    // If set_up is set, it is called with the new world, for example to register the caller's own tests.
    std::function<void(World&)> set_up = nullptr;

    // If updated is set, it is called after each update that gave the recorded result, for example to ask about the
    // lists. It may throw, which ends the replay.
    std::function<void(const World&)> updated = nullptr;

    // Makes a shape from the text that TraceOptions::write_shape returned. It may throw.
    std::function<std::shared_ptr<const Shape>(ShapeKind, std::string_view)> read_shape = nullptr;
};

struct ReplayReport {
    // A Difference is the first place where the replay differs from the trace.
    struct Difference {
        std::size_t update;  // from 0: the update that differs, or the next one
        std::size_t call;    // from 0
        std::size_t line;    // from 1
        std::string what;
    };

    // The first three members count the calls that were run: those of the whole trace, or of the part up to the
    // difference.
    std::size_t call_count = 0;
    std::size_t update_count = 0;
    std::size_t question_count = 0;
    std::size_t body_count = 0;  // alive at the end
    std::size_t colliding_count = 0;
    std::optional<Difference> difference = {};
};

// Runs a trace until its end, or until the first difference. There are these kinds of differences: a new body's id, or
// the answer to a question, is not that of the trace (compared only if the trace began with an empty world); after an
// update, the digest or the number of colliding pairs is not that of the trace; the events of an update are not the
// difference of the lists before and after it; or an invariant is broken. An update that has no result in the trace, or
// failed, is run but not compared.
//
// Throws InvalidTrace if the text is no trace, or if a call in it is refused; NotSupported for a caller's own shape
// without a reader; ExecutorFailed as World::update does. Whatever the text is, memory and time are proportional to its
// length, and to the work of its updates.
ECODS_API ReplayReport replay(std::istream& trace, const ReplayOptions& options = {});

}  // namespace ecods
