#include "simd/instruction_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "environment/instruction_sets.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using environment::InstructionSetLimit;
using environment::supported_instruction_sets;
using environment::widest_instruction_set;

TEST(InstructionSet, IsTheWidestUnlessLimited) {
    EXPECT_EQ(instruction_set(), widest_instruction_set());
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        EXPECT_EQ(instruction_set(), set);
    }
    EXPECT_EQ(instruction_set(), widest_instruction_set());
}

// Sets the variable that limits a run; afterwards it is as it was.
class LimitVariable {
  public:
    explicit LimitVariable(const char* value) {
        if (const char* before = std::getenv(environment::limit_variable)) before_ = before;
        setenv(environment::limit_variable, value, 1);
    }
    ~LimitVariable() {
        if (before_) {
            setenv(environment::limit_variable, before_->c_str(), 1);
        } else {
            unsetenv(environment::limit_variable);
        }
    }
    LimitVariable(const LimitVariable&) = delete;
    LimitVariable& operator=(const LimitVariable&) = delete;

  private:
    std::optional<std::string> before_;
};

TEST(InstructionSet, AVariableMakesARunOneOnANarrowerProcessor) {
    for (const InstructionSet set : environment::all_instruction_sets) {
        const InstructionSetLimit afterwards_as_before(instruction_set());
        const LimitVariable variable(environment::name(set));
        environment::limit_by_variable();
        EXPECT_EQ(instruction_set(), std::min(set, supported_instruction_set()));
        EXPECT_EQ(supported_instruction_sets().back(), instruction_set());
        EXPECT_EQ(supported_instruction_sets().front(), InstructionSet::baseline);
    }
}

TEST(InstructionSet, AVariableThatNamesNoSetEndsTheRun) {
    for (const char* const value : {"", "avx", "AVX2", "avx2 ", "native"}) {
        const LimitVariable variable(value);
        EXPECT_THROW(environment::limit_by_variable(), std::invalid_argument) << value;
        EXPECT_THROW(supported_instruction_sets(), std::invalid_argument) << value;
    }
}

TEST(InstructionSet, WhatIsNotSupportedIsNotUsed) {
    const InstructionSetLimit limit(InstructionSet::avx512);
    EXPECT_EQ(instruction_set(), supported_instruction_set());
#if ECODS_CAN_DISPATCH
    EXPECT_EQ(supported_instruction_set() >= InstructionSet::avx2, __builtin_cpu_supports("avx2") != 0);
    const bool has_all = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    EXPECT_EQ(supported_instruction_set() == InstructionSet::avx512, has_all);
#else
    EXPECT_EQ(supported_instruction_set(), InstructionSet::baseline);
#endif
}

TEST(InstructionSet, IsOneForAllThreads) {
    const InstructionSetLimit limit(InstructionSet::baseline);
    InstructionSet seen = InstructionSet::avx512;
    std::thread([&] { seen = instruction_set(); }).join();
    EXPECT_EQ(seen, InstructionSet::baseline);
}

#if ECODS_CAN_DISPATCH
// Where this is in the program, which is another place in each version.
ECODS_ALWAYS_INLINE const void* own_place(int) noexcept {
    const void* place;
    asm volatile("lea 0(%%rip), %0" : "=r"(place));
    return place;
}

TEST(Dispatch, HasAVersionForEachInstructionSet) {
    std::set<const void*> places;
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        places.insert(dispatch<own_place>(0));
    }
    EXPECT_EQ(places.size(), supported_instruction_sets().size());
}
#endif

class Sum {
  public:
    ECODS_ALWAYS_INLINE int& add(int x) noexcept { return sum_ += x; }
    ECODS_ALWAYS_INLINE int get() const noexcept { return sum_; }

  private:
    int sum_ = 0;
};

ECODS_ALWAYS_INLINE int& larger(int& a, int& b) noexcept {
    return a > b ? a : b;
}

TEST(Dispatch, HandsOverArgumentsAndResultsAsTheyAre) {
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        Sum sum;
        dispatch<&Sum::add>(sum, 3) += 4;
        const Sum& same = sum;
        EXPECT_EQ(dispatch<&Sum::get>(same), 7) << environment::name(set);
        int a = 1, b = 2;
        EXPECT_EQ(&dispatch<larger>(a, b), &b) << environment::name(set);
    }
}

}  // namespace
}  // namespace ecods
