// Executors for tests.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "ecods/world_options.hpp"

namespace ecods {

// New threads for each run. Each takes the next task that is left.
class ThreadExecutor final : public Executor {
  public:
    explicit ThreadExecutor(std::size_t worker_count) : worker_count_(worker_count) {}

    std::size_t worker_count() const noexcept override { return worker_count_; }
    void run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) override {
        ++runs;
        std::atomic<std::size_t> next = 0;
        std::vector<std::jthread> threads;  // which are joined, also if one of them cannot be made
        for (std::size_t worker = 0; worker < worker_count_; ++worker) {
            threads.emplace_back([&, worker] {
                for (std::size_t i = next++; i < task_count; i = next++) task(i, worker);
            });
        }
    }

    int runs = 0;

  private:
    std::size_t worker_count_;
};

// Does whatever a test wants.
class ScriptedExecutor final : public Executor {
  public:
    std::size_t worker_count() const noexcept override { return 2; }
    void run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) override {
        script(task_count, task);
    }

    std::function<void(std::size_t, const std::function<void(std::size_t, std::size_t)>&)> script;
};

}  // namespace ecods
