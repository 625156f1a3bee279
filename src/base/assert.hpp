// Preconditions that a caller inside the library must keep are checked in builds without NDEBUG.
#pragma once

#include <cassert>

// Aborts with the condition, file and line if the condition does not hold; with NDEBUG, is nothing and evaluates
// nothing. It is for mistakes in the library itself, and for what a caller must keep where a check would cost too much
// (finite poses): other mistakes of a user are typed errors (ecods/error.hpp).
#define ECODS_ASSERT(condition) assert(condition)
