#include <exception>
#include <span>

#include "world/first_failure.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// Each test is a function of its pair, so which worker runs it when cannot be seen in an answer; each verdict is at one
// worker, and so are its answer and its witness. All tests are run, also when one throws.
template <class Question, class... Arguments>
void World::Impl::answer_tests(PairVerdicts& pairs, Question question, const Arguments&... arguments) {
    FirstFailure failure;
    const std::span<const VerdictIndex> pair_tests = pairs.tests();
    workers.run(pair_tests.size(), [&](std::size_t at, QueryMemory& memory) {
        // A pair's bodies lie anywhere: those of a later pair are fetched while this one is decided.
        constexpr std::size_t ahead = 2;
        if (at + ahead < pair_tests.size()) bodies.prefetch(pairs.verdicts()[pair_tests[at + ahead]].proxies());
        const VerdictIndex index = pair_tests[at];
        Answer& answer = pairs.answer(index);
        if (answer != Answer::none) return;
        const BodyPair& ids = pairs.verdicts()[index].bodies;
        const ProxyPair pair = pairs.verdicts()[index].proxies();
        try {
            answer = ask(pair, question, arguments..., memory, pairs.witness(index)) ? Answer::yes : Answer::no;
        } catch (...) {
            failure.keep(ids, std::current_exception());
        }
    });
    failure.rethrow();
}

void World::Impl::test_pairs() {
    answer_tests(collisions, &TwoBodyTest::intersects_again);
}

void World::Impl::test_close_pairs() {
    if (!closeness.wanted()) return;
    answer_tests(closeness.pairs(), &TwoBodyTest::within_again, *closeness.wanted());
}

}  // namespace ecods
