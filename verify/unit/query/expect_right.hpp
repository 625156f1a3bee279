// That every answer is the oracle's, of any of the judge's truths that are asked with a memory and a witness.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "ecods/intersection.hpp"
#include "environment/each_environment.hpp"
#include "judge/case_truth.hpp"
#include "scenes/each_case.hpp"

namespace ecods {

inline void expect_none(const std::optional<judge::Wrong>& wrong) {
    ASSERT_FALSE(wrong) << wrong->question << ": expected " << wrong->expected << ", got " << wrong->got;
}

template <class Truth>
void expect_right(const Truth& truth, QueryMemory& memory, PairWitness& witness) {
    expect_none(truth.ask(memory, witness));
}

// With a memory and a witness that know nothing.
template <class Truth>
void expect_right_everywhere(const Truth& truth) {
    const auto ask = [&] {
        QueryMemory memory;
        PairWitness witness;
        return truth.ask(memory, witness);
    };
    environment::in_each_environment(ask, [](const auto& wrong, const std::string& where) {
        SCOPED_TRACE(where);
        expect_none(wrong);
    });
}

// A case is as its recipe promises, and every answer about it as the oracle's. Counts its kind.
template <class Case>
void expect_right(const Case& made, const judge::Judged<Case>& judged, QueryMemory& memory, PairWitness& witness,
                  std::map<std::string, int>& kinds) {
    for (const judge::Promise& promise : judge::promises_of(made, judged.truth)) {
        ASSERT_TRUE(promise.is_kept) << "promised " << promise.promised << ", found " << promise.found;
    }
    ++kinds[judge::kind_of(judged.truth)];
    expect_none(judge::ask(judged.truth, memory, witness));
}

// Of each family, with one witness, which comes from other bodies each time. Returns how often each kind was true.
template <class Case, class Count>
std::map<std::string, int> expect_all_right(scenes::Families<Case> families, std::uint32_t seed, const Count& count) {
    std::map<std::string, int> kinds;
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(families, seed, count, [&](const Case& made) {
        expect_right(made, judge::Judged<Case>(made), memory, witness, kinds);
    });
    return kinds;
}

// Neither instruction sets nor rounding modes matter, nor what a question leaves in the memory.
template <class Case, class... Options>
void expect_all_right_everywhere(scenes::Families<Case> families, std::uint32_t seed, int count,
                                 const Options&... options) {
    scenes::for_each_case(families, seed, count, [&](const Case& made) {
        expect_right_everywhere(judge::Judged<Case>(made, options...).truth);
    });
}

// There are so many kinds, each more often than that.
inline void expect_each(const std::map<std::string, int>& kinds, std::size_t kind_count, int often) {
    EXPECT_EQ(kinds.size(), kind_count);
    for (const auto& [kind, count] : kinds) EXPECT_GT(count, often) << kind;
}

}  // namespace ecods
