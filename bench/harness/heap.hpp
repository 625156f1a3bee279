// Bytes that this process has allocated and not freed, as the C library's allocator counts them: what was asked for,
// rounded up to its units. What a library maps by itself is not in it.
#pragma once

#include <malloc.h>

namespace ecods::bench {

inline double heap_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace ecods::bench
