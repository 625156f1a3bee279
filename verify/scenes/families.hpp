// Families of cases: each makes cases of one kind, and has a name.
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scenes/random.hpp"

namespace ecods::scenes {

// `make` is deterministic: a random generator's state gives the same bits on every machine.
template <class Case>
struct Family {
    std::string_view name;
    Case (*make)(Random& random);
};

template <class Case>
using Families = std::span<const Family<Case>>;

template <class Case>
const Family<Case>& family_named(Families<Case> families, std::string_view name) {
    const auto found = std::ranges::find(families, name, &Family<Case>::name);
    if (found == families.end()) throw std::logic_error("there is no family " + std::string(name));
    return *found;
}

template <class Case>
const Family<Case>& any_family(Families<Case> families, Random& random) {
    return families[random.below(static_cast<std::uint32_t>(families.size()))];
}

}  // namespace ecods::scenes
