// Preconditions that a caller inside the library must keep are checked in builds without NDEBUG.
#pragma once

#include <cassert>

// Aborts with the condition, file and line if the condition does not hold; with NDEBUG, is nothing and evaluates
// nothing. It is for mistakes in the library itself: a user's mistakes are typed errors (ecods/error.hpp).
#define ECODS_ASSERT(condition) assert(condition)
