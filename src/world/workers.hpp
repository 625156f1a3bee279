// Who runs the tests of an update, and the memory of each.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "ecods/executor.hpp"
#include "ecods/intersection.hpp"

namespace ecods {

// Whether an executor keeps its promises: an answer that is not there, or that two threads wrote at once, must not pass
// for one.
class ExecutorWatch {
  public:
    ExecutorWatch(std::size_t task_count, std::size_t worker_count) : runs_(task_count), is_busy_(worker_count) {}

    bool enter(std::size_t task, std::size_t worker) noexcept;
    void leave(std::size_t worker) noexcept { std::atomic_ref(is_busy_[worker]).store(0, std::memory_order_release); }
    void require_whole() const;  // throws ExecutorFailed

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

    // Calls `run_one(i, memory)` once for each i below `count`, by several threads if there is an executor, no two of
    // them at once with one memory. It must not throw. Throws ExecutorFailed.
    template <class RunOne>
    void run(std::size_t count, const RunOne& run_one) {
        // Small enough that the workers end together, large enough that handing one out costs little beside it.
        constexpr std::size_t items_per_task = 32;
        if (executor_ == nullptr || count <= items_per_task) {
            for (std::size_t at = 0; at < count; ++at) run_one(at, memories_[0]);
            return;
        }
        const std::size_t task_count = (count + items_per_task - 1) / items_per_task;
        ExecutorWatch watch(task_count, memories_.size());
        executor_->run(task_count, [&](std::size_t task, std::size_t worker) {
            if (!watch.enter(task, worker)) return;
            const std::size_t end = std::min(count, (task + 1) * items_per_task);
            for (std::size_t at = task * items_per_task; at < end; ++at) run_one(at, memories_[worker]);
            watch.leave(worker);
        });
        watch.require_whole();
    }

    // For questions of the thread that calls the world, when no update runs.
    QueryMemory& caller_memory() noexcept { return memories_[0]; }

    QueryCounts counts() const {
        QueryCounts sum;
        for (const QueryMemory& memory : memories_) sum += memory.counts();
        return sum;
    }

  private:
    std::shared_ptr<Executor> executor_;
    std::vector<QueryMemory> memories_;  // one a worker
};

}  // namespace ecods
