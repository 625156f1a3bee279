// Defines Asking, which manages the memory, the witness and the counts of a query while the query runs.
#pragma once

#include <optional>

#include "ecods/ask.hpp"

namespace ecods {

// An OwnMemory lends a memory to one query: the memory that the calling thread's last query used, or, while that memory
// is lent to another query, a new one.
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

// An Asking provides the memory and the witness of a query while the query runs, and at the end adds the work of the
// query to ask.counts. `ask` must outlive this object.
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

    // Returns the caller's witness, or, if the caller passed none, an empty witness.
    PairWitness& witness() noexcept { return ask_.witness != nullptr ? *ask_.witness : no_witness_; }

  private:
    void add_counts() noexcept;

    const Ask& ask_;
    PairWitness no_witness_;
    std::optional<OwnMemory> own_;
    std::optional<QueryCounts> before_;
};

}  // namespace ecods
