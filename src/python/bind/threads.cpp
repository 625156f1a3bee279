#include "python/bind/threads.hpp"

#include <pybind11/pybind11.h>
#include <unistd.h>

namespace ecods::python {

Threads::Threads(std::size_t count) : process_(getpid()) {
    for (std::size_t worker = 1; worker < count; ++worker) others_.emplace_back([this, worker] { work(worker); });
}

Threads::~Threads() {
    if (getpid() != process_) {
        for (std::thread& each : others_) each.detach();
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    begins_.notify_all();
    for (std::thread& each : others_) each.join();
}

void Threads::run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) {
    if (others_.empty() || task_count < 2 || getpid() != process_) {
        for (std::size_t i = 0; i < task_count; ++i) task(i, 0);
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        task_ = &task;
        task_count_ = task_count;
        next_ = 0;
        busy_ = others_.size();
        ++round_;
    }
    begins_.notify_all();
    take_tasks(0);
    std::unique_lock lock(mutex_);
    ends_.wait(lock, [this] { return busy_ == 0; });
}

void Threads::work(std::size_t worker) {
    std::uint64_t done = 0;
    while (true) {
        {
            std::unique_lock lock(mutex_);
            begins_.wait(lock, [&] { return is_over_ || round_ != done; });
            if (is_over_) return;
            done = round_;
        }
        take_tasks(worker);
        const std::lock_guard lock(mutex_);
        if (--busy_ == 0) ends_.notify_one();
    }
}

void Threads::take_tasks(std::size_t worker) {
    while (true) {
        std::size_t mine = 0;
        {
            const std::lock_guard lock(next_mutex_);
            if (next_ == task_count_) return;
            mine = next_++;
        }
        (*task_)(mine, worker);
    }
}

std::shared_ptr<Executor> make_threads(std::size_t count) {
    if (count == 0) throw pybind11::value_error("threads: at least one is needed");
    return count == 1 ? nullptr : std::make_shared<Threads>(count);
}

}  // namespace ecods::python
