// A test of cases of every family. For programs of GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include <type_traits>

#include "scenes/families.hpp"

namespace ecods::scenes {

inline int count_of(int count, std::string_view) {
    return count;
}
template <class Count>
int count_of(const Count& count, std::string_view family) {
    return count(family);
}

// Calls `test` with `count` cases of each family, drawn from one generator, up to the first fatal failure. `count` is a
// number or a function of the family's name; `test` takes a case, or a case and the generator.
template <class Case, class Count, class Test>
void for_each_case(Families<Case> families, Random& random, const Count& count, const Test& test) {
    for (const Family<Case>& family : families) {
        for (int i = 0; i < count_of(count, family.name); ++i) {
            SCOPED_TRACE(testing::Message() << family.name << ' ' << i);
            if constexpr (std::is_invocable_v<Test, const Case&>) {
                test(family.make(random));
            } else {
                test(family.make(random), random);
            }
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

// The same with a generator for each family, which begins with the seed.
template <class Case, class Count, class Test>
void for_each_case(Families<Case> families, std::uint32_t seed, const Count& count, const Test& test) {
    for (const Family<Case>& family : families) {
        Random random(seed);
        for_each_case(Families<Case>(&family, 1), random, count, test);
    }
}

}  // namespace ecods::scenes
