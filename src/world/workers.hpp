// Runs the two-body tests of an update or a question, in parallel if the world has an executor. Each worker has its own
// QueryMemory.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/world_options.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {

// ExecutorWatch checks that an executor runs each task exactly once, and never two tasks at once on one worker.
// Otherwise an answer could be used that was never computed, or that two threads wrote at once.
class ExecutorWatch {
  public:
    ExecutorWatch(std::size_t task_count, std::size_t worker_count) : runs_(task_count), is_busy_(worker_count) {}

    bool enter(std::size_t task, std::size_t worker) noexcept;
    void leave(std::size_t worker) noexcept { std::atomic_ref(is_busy_[worker]).store(0, std::memory_order_release); }
    void require_whole() const;  // throws ExecutorFailed unless each task ran once

  private:
    std::vector<std::uint8_t> runs_;
    std::vector<std::uint8_t> is_busy_;
    std::atomic<bool> is_broken_ = false;
};

class Workers {
  public:
    explicit Workers(std::shared_ptr<Executor> executor)
        : executor_(std::move(executor)),
          memories_(executor_ ? std::max<std::size_t>(1, executor_->worker_count()) : 1) {}

    // Calls `run_one(i, memory)` once for each i below `count`. If there is an executor, several threads make these
    // calls, but never two at once with the same memory. `run_one` must not throw. Throws ExecutorFailed.
    template <class RunOne>
    void run(std::size_t count, const RunOne& run_one) {
        run_in(memories_, count, run_one);
    }

    // Calls `run_one` as run() does, for a question; other threads may ask questions at the same time. If `ask` gives a
    // memory, or there is no executor, the calling thread makes all calls. Otherwise the executor makes them, for one
    // question at a time.
    template <class RunOne>
    void run_question(std::size_t count, const Ask& ask, const RunOne& run_one) const {
        if (ask.memory != nullptr || executor_ == nullptr) {
            Asking asking(ask);
            for (std::size_t at = 0; at < count; ++at) run_one(at, asking.memory());
            return;
        }
        const std::scoped_lock lock(question_mutex_);
        question_memories_.resize(memories_.size());
        for (QueryMemory& memory : question_memories_) memory.reset_counts();
        struct AddCounts {  // adds the counts even if the executor fails
            ~AddCounts() {
                if (to == nullptr) return;
                for (const QueryMemory& memory : memories) *to += memory.counts();
            }
            QueryCounts* to;
            const std::vector<QueryMemory>& memories;
        } const add_counts{ask.counts, question_memories_};
        run_in(question_memories_, count, run_one);
    }

    // Returns the summed counts of all updates.
    QueryCounts counts() const {
        QueryCounts sum;
        for (const QueryMemory& memory : memories_) sum += memory.counts();
        return sum;
    }

  private:
    template <class RunOne>
    void run_in(std::vector<QueryMemory>& memories, std::size_t count, const RunOne& run_one) const {
        // A task has 32 items: few enough that all workers end at about the same time, and enough that handing out a
        // task costs little in comparison.
        constexpr std::size_t items_per_task = 32;
        if (executor_ == nullptr || count <= items_per_task) {
            for (std::size_t at = 0; at < count; ++at) run_one(at, memories[0]);
            return;
        }
        const std::size_t task_count = (count + items_per_task - 1) / items_per_task;
        ExecutorWatch watch(task_count, memories.size());
        executor_->run(task_count, [&](std::size_t task, std::size_t worker) {
            if (!watch.enter(task, worker)) return;
            const std::size_t end = std::min(count, (task + 1) * items_per_task);
            for (std::size_t at = task * items_per_task; at < end; ++at) run_one(at, memories[worker]);
            watch.leave(worker);
        });
        watch.require_whole();
    }

    std::shared_ptr<Executor> executor_;
    std::vector<QueryMemory> memories_;  // one for each worker
    mutable std::mutex question_mutex_;
    mutable std::vector<QueryMemory> question_memories_;  // one for each worker; used by questions only
};

}  // namespace ecods
