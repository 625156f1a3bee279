// Defines what every public header needs: C++20, the library's version, and which names a shared library exports.
#pragma once

#if __cplusplus < 202002L
#error "ECoDS needs C++20: compile with -std=c++20 or a later standard."
// Includes a file that does not exist, to stop the compiler here, before it lists what an older standard does not know.
#define ECODS_STOP "the error above"
#include ECODS_STOP
#endif

// CMake reads the version from here.
#define ECODS_VERSION_MAJOR 0
#define ECODS_VERSION_MINOR 4
#define ECODS_VERSION_PATCH 0

// Marks a part of the library's interface. A shared library hides everything else; a static one is not changed.
#define ECODS_API [[gnu::visibility("default")]]

// Marks a member of a public class that is not part of the interface.
#define ECODS_HIDDEN [[gnu::visibility("hidden")]]
