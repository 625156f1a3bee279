#include "unit/world/watched_memory.hpp"

#include <malloc.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace ecods {
namespace {

constexpr std::size_t never = ~std::size_t{0};
thread_local std::size_t allocations_left = never;
thread_local bool has_failed = false;

void* allocate(std::size_t size, std::size_t alignment) {
    if (allocations_left != never && allocations_left-- == 0) {
        has_failed = true;
        throw std::bad_alloc();
    }
    void* const memory = alignment <= alignof(std::max_align_t)
                             ? std::malloc(size)
                             : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

// Through a pointer to volatile: a compiler may leave out what is written to memory that ends.
void release(void* memory) noexcept {
    if (memory == nullptr) return;
    void* (*const volatile fill)(void*, int, std::size_t) = std::memset;
    fill(memory, 0xa5, malloc_usable_size(memory));
    std::free(memory);
}

}  // namespace

void fail_allocation_after(std::size_t count) noexcept {
    has_failed = false;
    allocations_left = count;
}

bool allocation_has_failed() noexcept {
    allocations_left = never;
    return has_failed;
}

}  // namespace ecods

void* operator new(std::size_t size) {
    return ecods::allocate(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return ecods::allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    ecods::release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    ecods::release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    ecods::release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    ecods::release(memory);
}
