// Sums of products of natural numbers and powers of two, of either sign, over a natural number.
#pragma once

#include <span>

#include "exact/number/natural.hpp"

namespace ecods::exact {

// A summand is the number a b 2^e, or its negative.
struct Summand {
    NaturalSpan a, b;
    int e = 0;
    bool is_negative = false;
};

// Returns the double nearest to the sum of at most 64 terms over `den`, ties to even; a zero is +0. Numbers have the
// widths that natural_sum.cpp names.
double round_sum(std::span<const Summand> terms, NaturalSpan den) noexcept;

}  // namespace ecods::exact
