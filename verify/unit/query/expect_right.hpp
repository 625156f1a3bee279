// That every answer is the oracle's, of any of the judge's truths that are asked with a memory and a witness.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ecods/intersection.hpp"
#include "environment/each_environment.hpp"

namespace ecods {

template <class Truth>
void expect_right(const Truth& truth, QueryMemory& memory, PairWitness& witness) {
    const auto wrong = truth.ask(memory, witness);
    ASSERT_FALSE(wrong) << wrong->question << ": expected " << wrong->expected << ", got " << wrong->got;
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
        ASSERT_FALSE(wrong) << where << ": " << wrong->question << ": expected " << wrong->expected << ", got "
                            << wrong->got;
    });
}

}  // namespace ecods
