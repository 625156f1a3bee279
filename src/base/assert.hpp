// Preconditions that a caller inside the library must keep, checked in builds without NDEBUG.
#pragma once

#include <cassert>

// Aborts with the condition, file and line if it does not hold; with NDEBUG, is nothing and evaluates nothing. For
// mistakes in the library itself: what a user can get wrong is a typed error (ecods/error.hpp).
#define ECODS_ASSERT(condition) assert(condition)
