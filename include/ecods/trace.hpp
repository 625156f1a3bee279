// A record of the calls that changed a World, to be run again by replay.hpp. A bug report is a file.
//
// World::trace_to starts it, with the bodies that are in the world at that moment. From then on every call that changed
// something is written, one line each, in the order of the calls; a call that threw is not, as it changed nothing.
// Numbers are written without loss. The text, version 1:
//
//     ecods-trace 1
//     world sweep_and_prune 0                   broad phase; places for bodies that were used before
//     mesh 1 4 2                                number, vertices, triangles; then these:
//     v 0x0p+0 0x1.8p+1 -0x1p-1074
//     t 0 1 2
//     solid 3 4 4                               as a mesh, of which the shape is a Solid
//     convex 4 4 4                              the same, a ConvexSolid
//     shape 2 7 any text                        number, kind, and what the caller's writer said
//     create 1.0 1 R R R t R R R t R R R t      body, mesh or shape, pose: [R t] row by row, hexadecimal
//     create_with 2.0 1 R ... t 1 f 2a          the same; then groups, mask and user data, hexadecimal
//     destroy 1.0
//     set_pose 1.0 R R R t R R R t R R R t
//     set_poses 2                               then so many lines: p, body, pose
//     p 1.0 R R R t R R R t R R R t
//     set_shape 1.0 2
//     set_filter 1.0 1 ffffffffffffffff         groups, mask; hexadecimal
//     set_pair_enabled 1.0 2.0 0                0: off, 1: on
//     set_user_data 1.0 2a                      hexadecimal
//     set_clearance 0x1.8p-3                    or none
//     set_solids 1                              0: not related, 1: related
//     update 0123456789abcdef 5                 digest, colliding pairs
//     note any text
//
// and, where questions are written (TraceOptions), with the digest of the answer first:
//
//     first_hit 0123456789abcdef A A A B B B none      a segment; a filter: groups, mask, or none
//     first_hit_of_ray 0123456789abcdef O O O D D D inf none
//     all_hits, all_hits_of_ray                        the same
//     cast 0123456789abcdef 1.0 M M M 0x1p+0           body, motion, limit of time
//     meetings 0123456789abcdef 2                      then so many lines p, as of set_poses
//     nearest 0123456789abcdef 1.0 inf                 body, limit of distance
//     closest_pair 0123456789abcdef inf
//     bodies_containing 0123456789abcdef P P P
//     depths 0123456789abcdef
//     solid_distances 0123456789abcdef inf             limit of distance
//
// A body is written as slot and generation. "update" stands in the file before the update runs, and its result is
// added after: of a program that crashes, the last line is "update" alone. Of an update that threw it is "update
// failed". Lines end with LF; a file whose first line ends with CR LF, as some editors write it, is read as well, and a
// byte order mark at its beginning is passed over. reserve() is not written: it changes no answer. set_test cannot be,
// and leaves a note.
#pragma once

#include <functional>
#include <string>

#include "ecods/export.hpp"
#include "ecods/shape.hpp"

namespace ecods {

struct TraceOptions {
    // What is to be written of a shape of the caller's own, from which ReplayOptions::read_shape makes it again: one
    // line. Without it, or where it says more than a line, a call that brings such a shape in throws NotSupported and
    // changes nothing.
    std::function<std::string(const Shape&)> write_shape = nullptr;

    // Whether the questions above are written, too, where they are asked in the world's own memory. A question that
    // throws is not. A replay asks them again and compares the answers.
    bool questions = false;
};

}  // namespace ecods
