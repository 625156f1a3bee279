// A question under way, as its Ask says.
#pragma once

#include <optional>

#include "ecods/ask.hpp"

namespace ecods {

// Lends the calling thread a memory of its own: the one that its last question used, or a new one while that is lent.
class OwnMemory {
  public:
    OwnMemory();
    ~OwnMemory();
    OwnMemory(const OwnMemory&) = delete;
    OwnMemory& operator=(const OwnMemory&) = delete;

    QueryMemory& get() noexcept { return *memory_; }

  private:
    std::unique_ptr<QueryMemory> memory_;
};

// Gives a question its memory and its witness for as long as it runs, and adds its work to the counts of the Ask at the
// end. `ask` must outlive it.
class Asking {
  public:
    explicit Asking(const Ask& ask) : ask_(ask) {
        if (ask.memory == nullptr) [[unlikely]]
            own_.emplace();
        if (ask.counts != nullptr) [[unlikely]]
            before_ = memory().counts();
    }
    ~Asking() {
        if (ask_.counts != nullptr) [[unlikely]]
            add_counts();
    }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;

    QueryMemory& memory() noexcept { return ask_.memory != nullptr ? *ask_.memory : own_->get(); }

    // The caller's witness, or one that knows nothing.
    PairWitness& witness() noexcept { return ask_.witness != nullptr ? *ask_.witness : no_witness_; }

  private:
    void add_counts() noexcept;

    const Ask& ask_;
    PairWitness no_witness_;
    std::optional<OwnMemory> own_;
    std::optional<QueryCounts> before_;
};

}  // namespace ecods
