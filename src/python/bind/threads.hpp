// Threads of Python's worlds and of questions about many poses. They never touch the interpreter.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ecods/executor.hpp"

namespace ecods::python {

// The thread that calls, and count - 1 others, which wait. In a process that was forked, where they are not, the thread
// that calls does the work.
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
    long process_;  // that started them

    std::mutex mutex_;
    std::condition_variable begins_;
    std::condition_variable ends_;
    std::uint64_t round_ = 0;  // how often run() was called
    std::size_t busy_ = 0;     // threads that have not ended this round
    bool is_over_ = false;

    std::mutex next_mutex_;
    std::size_t next_ = 0;
    std::size_t task_count_ = 0;
    const std::function<void(std::size_t, std::size_t)>* task_ = nullptr;
};

// Null for one thread. Throws ValueError unless there is at least one.
std::shared_ptr<Executor> make_threads(std::size_t count);

}  // namespace ecods::python
