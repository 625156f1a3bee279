#include <algorithm>
#include <atomic>
#include <mutex>

#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Small enough that the workers end together, large enough that handing one out costs little beside it.
constexpr std::size_t pairs_per_task = 32;

// What went wrong first, in the order of the pairs and not of time: which error is thrown depends neither on workers
// nor on history.
class FirstFailure {
  public:
    void keep(const BodyPair& bodies, std::exception_ptr error) {
        const std::lock_guard lock(mutex_);
        if (error_ && bodies > bodies_) return;
        bodies_ = bodies;
        error_ = std::move(error);
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    std::mutex mutex_;
    BodyPair bodies_;
    std::exception_ptr error_;
};

// Whether an executor keeps its promises: an answer that is not there, or that two threads wrote at once, must not pass
// for one.
class ExecutorWatch {
  public:
    ExecutorWatch(std::size_t task_count, std::size_t worker_count) : runs_(task_count), is_busy_(worker_count) {}

    bool enter(std::size_t task, std::size_t worker) noexcept {
        const bool is_valid = task < runs_.size() && worker < is_busy_.size() &&
                              std::atomic_ref(runs_[task]).exchange(1, std::memory_order_relaxed) == 0 &&
                              std::atomic_ref(is_busy_[worker]).exchange(1, std::memory_order_acquire) == 0;
        if (!is_valid) is_broken_.store(true, std::memory_order_relaxed);
        return is_valid;
    }
    void leave(std::size_t worker) noexcept { std::atomic_ref(is_busy_[worker]).store(0, std::memory_order_release); }
    void require_whole() const {
        if (is_broken_)
            throw ExecutorFailed(
                "the executor named a task or a worker that there is not, a task twice, or a worker that was busy");
        if (std::ranges::count(runs_, 0) != 0) throw ExecutorFailed("the executor did not run every task");
    }

  private:
    std::vector<std::uint8_t> runs_;
    std::vector<std::uint8_t> is_busy_;
    std::atomic<bool> is_broken_ = false;
};

}  // namespace

bool World::Impl::test(ProxyPair pair, QueryMemory& memory) const {
    return test_of(pair).ask(
        slots[pair.a].posed(), slots[pair.b].posed(),
        [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) { return t.intersects(a, b, memory); });
}

// Each verdict is at one worker, so its witness is, too.
bool World::Impl::test_again(VerdictIndex verdict, QueryMemory& memory) {
    const ProxyPair pair = verdicts[verdict].proxies();
    return test_of(pair).ask(slots[pair.a].posed(), slots[pair.b].posed(),
                             [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) {
                                 return t.intersects_again(a, b, memory, verdicts.witness(verdict));
                             });
}

// Each test is a function of its pair, so which worker runs it when cannot be seen in an answer. All tests are run,
// also when one throws.
void World::Impl::test_pairs() {
    FirstFailure failure;
    const auto test_one = [&](std::size_t at, QueryMemory& memory) {
        PairTest& pair_test = pair_tests[at];
        if (pair_test.answer != Answer::none) return;
        try {
            const bool is_colliding = test_again(pair_test.verdict, memory);
            pair_test.answer = is_colliding ? Answer::colliding : Answer::disjoint;
        } catch (...) {
            failure.keep(verdicts[pair_test.verdict].bodies, std::current_exception());
        }
    };
    if (executor == nullptr || pair_tests.size() <= pairs_per_task) {
        for (std::size_t at = 0; at < pair_tests.size(); ++at) test_one(at, memories[0]);
    } else {
        const std::size_t task_count = (pair_tests.size() + pairs_per_task - 1) / pairs_per_task;
        ExecutorWatch watch(task_count, memories.size());
        executor->run(task_count, [&](std::size_t task, std::size_t worker) {
            if (!watch.enter(task, worker)) return;
            const std::size_t end = std::min(pair_tests.size(), (task + 1) * pairs_per_task);
            for (std::size_t at = task * pairs_per_task; at < end; ++at) test_one(at, memories[worker]);
            watch.leave(worker);
        });
        watch.require_whole();
    }
    failure.rethrow();
}

}  // namespace ecods
