// Scripts as traces of a world (ecods/trace.hpp), both ways.
//
// What a trace does not hold stands in notes, which ecods_replay passes over: that a shape was a refit, room that was
// reserved, calls that must be refused, tests that are registered again or throw, updates after which nobody looks.
#pragma once

#include <istream>
#include <ostream>

#include "fuzz/script/play.hpp"
#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// Runs the script in a world by brute force that is traced. If the world throws, or crashes, the trace ends there.
void write_trace(const Script& script, std::ostream& out);

// Notes behind a trace that say which check failed.
void write_failure(const Failure& failure, std::ostream& out);

// Of any trace, if its user-defined shapes are those of user_shape.hpp. Throws InvalidTrace.
Script read_trace(std::istream& in);

// The bodies at the end of a script as a Wavefront OBJ file, for eyes only: points are rounded.
void write_picture(const Script& script, std::ostream& out);

}  // namespace ecods::fuzz
