#include "world/workers.hpp"

#include "ecods/error.hpp"

namespace ecods {

bool ExecutorWatch::enter(std::size_t task, std::size_t worker) noexcept {
    const bool is_valid = task < runs_.size() && worker < is_busy_.size() &&
                          std::atomic_ref(runs_[task]).exchange(1, std::memory_order_relaxed) == 0 &&
                          std::atomic_ref(is_busy_[worker]).exchange(1, std::memory_order_acquire) == 0;
    if (!is_valid) is_broken_.store(true, std::memory_order_relaxed);
    return is_valid;
}

void ExecutorWatch::require_whole() const {
    if (is_broken_) {
        throw ExecutorFailed(
            "the executor named a task or a worker that there is not, a task twice, or a worker that was busy");
    }
    if (std::ranges::count(runs_, 0) != 0) throw ExecutorFailed("the executor did not run every task");
}

}  // namespace ecods
