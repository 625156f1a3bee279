#include <exception>
#include <span>

#include "world/first_failure.hpp"
#include "world/world_impl.hpp"

namespace ecods {

bool World::Impl::test(ProxyPair pair, QueryMemory& memory) const {
    return ask(pair, [&](auto& t, auto& a, auto& b) { return t.intersects(a, b, memory); });
}

bool World::Impl::test_within(ProxyPair pair, double d, QueryMemory& memory) const {
    return ask(pair, [&](auto& t, auto& a, auto& b) { return t.within(a, b, d, memory); });
}

// Each test is a function of its pair, so which worker runs it when cannot be seen in an answer; each verdict is at one
// worker, and so are its answer and its witness. All tests are run, also when one throws.
template <class Ask>
void World::Impl::answer_tests(PairVerdicts& pairs, const Ask& ask_again) {
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
            const bool is_positive =
                ask(pair, [&](auto& t, auto& a, auto& b) { return ask_again(t, a, b, memory, pairs.witness(index)); });
            answer = is_positive ? Answer::yes : Answer::no;
        } catch (...) {
            failure.keep(ids, std::current_exception());
        }
    });
    failure.rethrow();
}

void World::Impl::test_pairs() {
    answer_tests(collisions, [](auto& t, auto& a, auto& b, auto& memory, auto& witness) {
        return t.intersects_again(a, b, memory, witness);
    });
}

void World::Impl::test_close_pairs() {
    if (!closeness.wanted()) return;
    const double d = *closeness.wanted();
    answer_tests(closeness.pairs(), [d](auto& t, auto& a, auto& b, auto& memory, auto& witness) {
        return t.within_again(a, b, d, memory, witness);
    });
}

}  // namespace ecods
