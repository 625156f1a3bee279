// Scripts as traces of a world (ecods/trace.hpp), both ways.
//
// Notes, which ecods_replay passes over, hold the rest of a script: that a shape is a refit, calls that reserve room,
// that must be refused or that register tests again, updates in which tests throw or after which nobody looks.
#pragma once

#include <istream>
#include <ostream>

#include "fuzz/script/play.hpp"
#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// Runs the script in a world by brute force that is traced. If the world throws, or crashes, the trace ends there.
void write_trace(const Script& script, std::ostream& out);

// Appends to a trace the notes that say which check failed.
void write_failure(const Failure& failure, std::ostream& out);

// Reads any trace whose user-defined shapes are those of user_shape.hpp. Throws InvalidTrace.
Script read_trace(std::istream& in);

// Writes the bodies at the end of a script as a Wavefront OBJ file, for eyes only: points are rounded.
void write_picture(const Script& script, std::ostream& out);

}  // namespace ecods::fuzz
