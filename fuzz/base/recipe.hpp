// A recipe makes input, and promises something of it.
#pragma once

namespace ecods::fuzz {

// The name of the check of such promises, by the oracle. Where it fails the input is wrong, and the library was not
// asked about it.
inline constexpr const char* recipe_check = "recipe";

}  // namespace ecods::fuzz
