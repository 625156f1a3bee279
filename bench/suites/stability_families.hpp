// The families of hard pairs that the page on numerical stability shows, with their parameter where they have one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenes/hard_pairs.hpp"

namespace ecods::bench {

// What the parameter of a family is, and with it the chart that the family belongs to.
enum class Parameter { none, distance, thickness_exponent, scale_exponent };

struct StabilityFamily {
    std::string name;
    Parameter parameter = Parameter::none;
    double value = 0;
    std::vector<scenes::PosedPair> pairs;
};

// Families with a parameter hold the same pairs for each of its values, moved, thinned or scaled. Deterministic.
std::vector<StabilityFamily> stability_families(std::size_t pair_count);

}  // namespace ecods::bench
