#include <exception>
#include <span>

#include "world/first_failure.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// Runs all tests, even if one throws; then throws the error of the least pair that threw. The answers do not depend on
// which worker runs a test or when: a test depends on its pair alone, and only one worker accesses the verdict, answer
// and witness of this pair.
template <class Question, class... Arguments>
void World::Impl::answer_tests(PairVerdicts& pairs, Question question, const Arguments&... arguments) {
    FirstFailure failure;
    const std::span<const VerdictIndex> pair_tests = pairs.tests();
    workers.run(pair_tests.size(), [&](std::size_t at, QueryMemory& memory) {
        // Prefetches the bodies of the pair two places ahead, because bodies of successive pairs lie anywhere in
        // memory.
        constexpr std::size_t ahead = 2;
        if (at + ahead < pair_tests.size()) bodies.prefetch(pairs.verdicts()[pair_tests[at + ahead]].proxies());
        const VerdictIndex index = pair_tests[at];
        Answer& answer = pairs.answer(index);
        if (answer != Answer::none) return;
        const BodyPair& ids = pairs.verdicts()[index].bodies;
        const ProxyPair pair = pairs.verdicts()[index].proxies();
        try {
            answer = ask(pair, question, arguments..., Ask(memory, pairs.witness(index))) ? Answer::yes : Answer::no;
        } catch (...) {
            failure.keep(ids, std::current_exception());
        }
    });
    failure.rethrow();
}

void World::Impl::test_pairs() {
    answer_tests(collisions, &TwoBodyTest::intersects);
}

void World::Impl::test_close_pairs() {
    if (!closeness.wanted()) return;
    answer_tests(closeness.pairs(), &TwoBodyTest::within, *closeness.wanted());
}

}  // namespace ecods
