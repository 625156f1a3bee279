// Checks for C++20, and defines the library's version and the macros that mark which names a shared library exports.
#pragma once

#if __cplusplus < 202002L
#error "ECoDS needs C++20: compile with -std=c++20 or a later standard."
// Includes a file that does not exist: the compiler stops here, before it reports all that an older standard lacks.
#define ECODS_STOP "the error above"
#include ECODS_STOP
#endif

// CMake reads the version from these three lines.
#define ECODS_VERSION_MAJOR 0
#define ECODS_VERSION_MINOR 4
#define ECODS_VERSION_PATCH 0

// Marks a name that belongs to the library's interface. A shared library hides all other names; in a static library the
// mark has no effect.
#define ECODS_API [[gnu::visibility("default")]]

// Marks a member of a public class that is not part of the interface.
#define ECODS_HIDDEN [[gnu::visibility("hidden")]]
