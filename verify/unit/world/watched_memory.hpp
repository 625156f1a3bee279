// The operator new of a test program: freed memory is overwritten, and any allocation can be made to fail.
//
// What reads memory after it was freed then gets what is no pose, no box and no pointer; without this it mostly gets
// what was there before, and a test sees nothing. To be linked with watched_memory.cpp.
#pragma once

#include <cstddef>

namespace ecods {

// Allocations of this thread from now on succeed `count` times, and the next one throws std::bad_alloc; those after it
// succeed again.
void fail_allocation_after(std::size_t count) noexcept;

// No allocation fails any more. Returns whether one has failed since fail_allocation_after().
bool allocation_has_failed() noexcept;

}  // namespace ecods
