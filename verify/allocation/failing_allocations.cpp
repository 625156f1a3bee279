#include "allocation/failing_allocations.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace ecods::allocation {
namespace {

// Of the FailingAllocation that lives. Plain counters, so that nothing here allocates.
constinit std::atomic<bool> is_watching{false};
constinit std::atomic<bool> is_lasting{false};
constinit std::atomic<std::uint64_t> failing_number{0};
constinit std::atomic<std::uint64_t> asked_count{0};

// Of the HeldBytes that lives.
constinit std::atomic<bool> is_weighing{false};
constinit std::atomic<std::uint64_t> held_bytes{0};

void* weighed(void* memory) noexcept {
    if (is_weighing.load(std::memory_order_relaxed)) held_bytes += malloc_usable_size(memory);
    return memory;
}

void release(void* memory) noexcept {
    if (is_weighing.load(std::memory_order_relaxed)) held_bytes -= malloc_usable_size(memory);
    std::free(memory);
}

bool fails_now() noexcept {
    if (!is_watching.load(std::memory_order_relaxed)) return false;
    const std::uint64_t number = asked_count.fetch_add(1);
    const std::uint64_t failing = failing_number.load();
    return number == failing || (number > failing && is_lasting.load());
}

void* allocate(std::size_t size) noexcept {
    return fails_now() ? nullptr : weighed(std::malloc(size == 0 ? 1 : size));
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
    if (fails_now()) return nullptr;
    void* memory = nullptr;
    const auto at_least =
        static_cast<std::size_t>(alignment) < sizeof(void*) ? sizeof(void*) : static_cast<std::size_t>(alignment);
    return posix_memalign(&memory, at_least, size == 0 ? 1 : size) == 0 ? weighed(memory) : nullptr;
}

void* require(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

FailingAllocation::FailingAllocation(std::uint64_t failing, Shortage shortage) noexcept : failing_(failing) {
    failing_number = failing;
    is_lasting = shortage == Shortage::lasting;
    asked_count = 0;
    is_watching = true;
}

FailingAllocation::~FailingAllocation() {
    is_watching = false;
}

std::uint64_t FailingAllocation::count() const noexcept {
    return asked_count;
}

HeldBytes::HeldBytes() noexcept {
    held_bytes = 0;
    is_weighing = true;
}

HeldBytes::~HeldBytes() {
    is_weighing = false;
}

std::uint64_t HeldBytes::count() const noexcept {
    return held_bytes;
}

}  // namespace ecods::allocation

using ecods::allocation::allocate;
using ecods::allocation::release;
using ecods::allocation::require;

void* operator new(std::size_t size) {
    return require(allocate(size));
}
void* operator new[](std::size_t size) {
    return require(allocate(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return require(allocate(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return require(allocate(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate(size, alignment);
}

void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete[](void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    release(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
    release(memory);
}
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept {
    release(memory);
}
