// Functions of the hot path that must not become calls, whatever a compiler's heuristics say.
#pragma once

#define ECODS_ALWAYS_INLINE [[gnu::always_inline]] inline
