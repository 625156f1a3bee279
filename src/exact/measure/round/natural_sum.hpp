// round_sum adds products of natural numbers and powers of two, of either sign, divides the sum by a natural number,
// and rounds once.
#pragma once

#include <span>

#include "exact/number/natural.hpp"

namespace ecods::exact {

// A Summand is the term a b 2^e, or -a b 2^e if is_negative.
struct Summand {
    NaturalSpan a, b;
    int e = 0;
    bool is_negative = false;
};

// Returns the double nearest to the sum of at most 64 terms, divided by `den`, ties to even; a zero is +0. Numbers must
// have the widths that natural_sum.cpp derives.
double round_sum(std::span<const Summand> terms, NaturalSpan den) noexcept;

}  // namespace ecods::exact
