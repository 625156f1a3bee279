// Allocations that fail on purpose, in a program that links this library: it brings the operators new and delete.
#pragma once

#include <cstdint>

namespace ecods::allocation {

// How often an allocation fails: memory that is short for a moment, and memory that stays short, which code that puts
// things back meets again.
enum class Shortage { once, lasting };

// While it lives, allocation number `failing` throws std::bad_alloc, and with a lasting shortage so do all after it.
// They are counted from 0, over all threads of the program. One at a time.
class FailingAllocation {
  public:
    explicit FailingAllocation(std::uint64_t failing, Shortage shortage = Shortage::once) noexcept;
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;
    FailingAllocation& operator=(const FailingAllocation&) = delete;

    std::uint64_t count() const noexcept;  // asked for so far
    bool has_failed() const noexcept { return count() > failing_; }

  private:
    std::uint64_t failing_;
};

// While it lives, allocations are counted, and none fails.
class CountedAllocations {
  public:
    std::uint64_t count() const noexcept { return none_.count(); }

  private:
    FailingAllocation none_{~std::uint64_t{0}};
};

// While it lives, the bytes that were allocated and not freed are counted, as the C library rounds them. One at a time;
// what was allocated before must not be freed.
class HeldBytes {
  public:
    HeldBytes() noexcept;
    ~HeldBytes();
    HeldBytes(const HeldBytes&) = delete;
    HeldBytes& operator=(const HeldBytes&) = delete;

    std::uint64_t count() const noexcept;
};

}  // namespace ecods::allocation
