// What every public header needs: C++20, and which names a shared library shows.
#pragma once

#if __cplusplus < 202002L
#error "ECoDS needs C++20: compile with -std=c++20 or a later standard."
// Not a file: the compiler stops here, in place of listing what an older standard does not know.
#define ECODS_STOP "the error above"
#include ECODS_STOP
#endif

// Part of the library's interface. A shared library hides everything else; in a static one it changes nothing.
#define ECODS_API [[gnu::visibility("default")]]

// Inside a class that is part of it, and not part of it.
#define ECODS_HIDDEN [[gnu::visibility("hidden")]]
