// Provides threads for Python's worlds and for questions about many poses. The threads never use the interpreter.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ecods/world_options.hpp"

namespace ecods::python {

// Runs tasks on the calling thread and on count - 1 other threads, which wait for work in between. A forked process
// does not have the other threads, so there the calling thread runs all tasks.
class Threads final : public Executor {
  public:
    explicit Threads(std::size_t count);
    ~Threads() override;

    std::size_t worker_count() const noexcept override { return others_.size() + 1; }
    void run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) override;

  private:
    void work(std::size_t worker);
    void take_tasks(std::size_t worker);

    std::vector<std::thread> others_;
    long process_;  // id of the process that started the threads

    std::mutex mutex_;
    std::condition_variable begins_;
    std::condition_variable ends_;
    std::uint64_t round_ = 0;  // number of calls of run() that used the other threads
    std::size_t busy_ = 0;     // number of other threads that have not finished this round
    bool is_over_ = false;

    std::mutex next_mutex_;
    std::size_t next_ = 0;
    std::size_t task_count_ = 0;
    const std::function<void(std::size_t, std::size_t)>* task_ = nullptr;
};

// Returns an executor with `count` threads, or null if `count` is 1. Throws ValueError if `count` is 0.
std::shared_ptr<Executor> make_threads(std::size_t count);

}  // namespace ecods::python
