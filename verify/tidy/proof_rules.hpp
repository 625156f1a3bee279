// Derivations of numeric bounds, and the claims in verify/proofs that prove them.
#pragma once

#include <string_view>
#include <vector>

#include "tidy/text_rules.hpp"

namespace ecods::tidy {

// Finds derivations of numeric bounds: comments that count roundings (by u', or by v = 2^-23 for floats) or that say
// "Derivation" or "Bound", and functions and constants whose name ends in _bound.
std::vector<Finding> find_derivations(std::string_view text);

// Finds the claims that comments name, each on a line of its own: `Claim: verify/proofs/NAME`. A finding is the NAME.
std::vector<Finding> find_claims(std::string_view text);

}  // namespace ecods::tidy
