// A loop over independent tasks on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace ecods::process {

// Calls task(i, worker) once for each i below `count`, by up to `jobs` threads, of which the caller's is one; worker is
// below `jobs`, and no two calls at once have the same. Returns when all have ended. If tasks throw, the others are
// still run, and the error of the least i passes through: it does not depend on the number of jobs.
template <class Task>
void for_each_in_parallel(std::size_t count, std::size_t jobs, const Task& task) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr error;
    std::size_t error_task = std::numeric_limits<std::size_t>::max();
    const auto work = [&](std::size_t worker) {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                task(i, worker);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (i < error_task) {
                    error_task = i;
                    error = std::current_exception();
                }
            }
        }
    };
    {
        std::vector<std::jthread> threads;  // which are joined, also if one of them cannot be made
        for (std::size_t worker = 1; worker < jobs && worker < count; ++worker) threads.emplace_back(work, worker);
        work(0);
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace ecods::process
