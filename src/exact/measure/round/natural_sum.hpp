// Sums of products of natural numbers and powers of two, of either sign, are divided by a natural number and rounded.
#pragma once

#include <span>

#include "exact/number/natural.hpp"

namespace ecods::exact {

// Holds the summand a b 2^e, or its negative.
struct Summand {
    NaturalSpan a, b;
    int e = 0;
    bool is_negative = false;
};

// Returns the double nearest to the sum of at most 64 terms over `den`, ties to even; a zero is +0. natural_sum.cpp
// names the widths that numbers may have.
double round_sum(std::span<const Summand> terms, NaturalSpan den) noexcept;

}  // namespace ecods::exact
