// Threads for Python's worlds and for questions about many poses. They never use the interpreter.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "ecods/world_options.hpp"

namespace ecods::python {

// An executor of the calling thread and count - 1 others, which wait for work. In a forked process, where the others do
// not exist, the calling thread does all the work.
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
    std::uint64_t round_ = 0;  // number of calls of run()
    std::size_t busy_ = 0;     // threads that have not finished this round
    bool is_over_ = false;

    std::mutex next_mutex_;
    std::size_t next_ = 0;
    std::size_t task_count_ = 0;
    const std::function<void(std::size_t, std::size_t)>* task_ = nullptr;
};

// Returns an executor, or null for one thread. Throws ValueError if `count` is 0.
std::shared_ptr<Executor> make_threads(std::size_t count);

}  // namespace ecods::python
