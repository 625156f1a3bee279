// Where work in parallel runs: the caller's threads, behind two functions.
//
// The library starts no thread. A thread pool, a task system or OpenMP fits in a few lines; the same executor may serve
// other users between two calls of the library.
#pragma once

#include <cstddef>
#include <functional>

#include "ecods/export.hpp"

namespace ecods {

class ECODS_API Executor {
  public:
    virtual ~Executor() = default;

    // How many calls may be under way at once; at least 1, and always the same.
    virtual std::size_t worker_count() const noexcept = 0;

    // Calls task(i, worker) once for each i below task_count, in any order, on any threads, with worker below
    // worker_count() and no two calls at once with the same worker; returns when all have ended, and what they wrote is
    // visible to the caller. The library's tasks do not throw. An executor that breaks this is found out
    // (ExecutorFailed): an answer that was not computed is never taken for one.
    virtual void run(std::size_t task_count, const std::function<void(std::size_t task, std::size_t worker)>& task) = 0;
};

}  // namespace ecods
