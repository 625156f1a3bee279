// What a source text may say.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ecods::tidy {

inline constexpr std::size_t lines_max = 500;

struct Finding {
    int line = 0;  // from 1
    std::string what;
};

// The text with comments blanked out: lines and columns stay. Literals are kept.
std::string without_comments(std::string_view text);

// Words that hide a decision about numbers (see words in the .cpp file), in code and comments, alone or as a part of a
// name; and decimal numbers with a negative exponent in code, which are tolerances somebody chose. A bound is a
// formula, and a power of two is written 0x1p-52.
std::vector<Finding> find_tolerances(std::string_view text);

std::size_t count_lines(std::string_view text);

}  // namespace ecods::tidy
