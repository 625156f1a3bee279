// ECODS_ASSERT checks preconditions of internal functions, in builds without NDEBUG.
#pragma once

#include <cassert>

// Aborts with the condition, file and line if the condition is false. With NDEBUG the condition is not evaluated.
// ECODS_ASSERT is for mistakes in the library itself, and for preconditions of callers that cost too much to check in
// every build (finite poses). All other mistakes of callers throw typed errors (ecods/error.hpp).
#define ECODS_ASSERT(condition) assert(condition)
