#include <exception>
#include <mutex>
#include <span>
#include <utility>

#include "world/world_impl.hpp"

namespace ecods {
namespace {

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

}  // namespace

bool World::Impl::test(ProxyPair pair, QueryMemory& memory) const {
    return test_of(pair).ask(
        bodies[pair.a].posed(), bodies[pair.b].posed(),
        [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) { return t.intersects(a, b, memory); });
}

// Each verdict is at one worker, so its witness is, too.
bool World::Impl::test_again(VerdictIndex verdict, QueryMemory& memory) {
    const ProxyPair pair = collisions.verdicts()[verdict].proxies();
    return test_of(pair).ask(bodies[pair.a].posed(), bodies[pair.b].posed(),
                             [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) {
                                 return t.intersects_again(a, b, memory, collisions.witness(verdict));
                             });
}

// Each test is a function of its pair, so which worker runs it when cannot be seen in an answer. All tests are run,
// also when one throws.
void World::Impl::test_pairs() {
    FirstFailure failure;
    const std::span<Collisions::PairTest> pair_tests = collisions.tests();
    workers.run(pair_tests.size(), [&](std::size_t at, QueryMemory& memory) {
        Collisions::PairTest& pair_test = pair_tests[at];
        if (pair_test.answer != Collisions::Answer::none) return;
        try {
            const bool is_colliding = test_again(pair_test.verdict, memory);
            pair_test.answer = is_colliding ? Collisions::Answer::colliding : Collisions::Answer::disjoint;
        } catch (...) {
            failure.keep(collisions.verdicts()[pair_test.verdict].bodies, std::current_exception());
        }
    });
    failure.rethrow();
}

}  // namespace ecods
