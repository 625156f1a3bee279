// Numbers in files.
#pragma once

#include <cstdint>
#include <string_view>

namespace ecods::scenes {

// The double nearest to a decimal; an infinity beyond the largest one, a zero below half of the smallest one. "nan" and
// "inf" are numbers, too. False if the word as a whole is no number. The locale plays no part: a number has a point and
// no other marks, whatever the program that calls this has set.
bool parse_number(std::string_view word, double& value);

// A whole number of 64 bits; false if the word as a whole is none, or one beyond them.
bool parse_integer(std::string_view word, std::int64_t& value);

}  // namespace ecods::scenes
