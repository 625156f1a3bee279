// What a source text may say.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ecods::tidy {

inline constexpr std::size_t lines_max = 350;          // of a file
inline constexpr std::size_t function_lines_max = 60;  // of a function, from its name to its brace

struct Finding {
    int line = 0;  // from 1
    std::string what;
};

// The text with comments blanked out: lines and columns stay. Literals are kept.
std::string without_comments(std::string_view text);
// The opposite: the comments of the text, at their lines and columns.
std::string comments_of(std::string_view text);

// Words that hide a decision about numbers (see words in the .cpp file), in code and comments, alone or as a part of a
// name; and decimal numbers with a negative exponent in code, which are tolerances somebody chose. A bound is a
// formula, and a power of two is written 0x1p-52.
std::vector<Finding> find_tolerances(std::string_view text);

// Words that a reader meets twice before they mean something, or that have a plainer name in the field: each finding
// says which to take instead. In names and comments, alone or as a part of a name.
std::vector<Finding> find_puzzling_words(std::string_view text);
// The same in prose, where some of them mean what they mean anywhere.
std::vector<Finding> find_puzzling_prose(std::string_view text);

// Finds comments whose first sentence does not begin with its subject or its verb, by the words that such comments
// begin with; and lower and upper bounds that are said by a denial. A comment begins where the line before is none.
std::vector<Finding> find_vague_openings(std::string_view text);

// Functions that are longer than function_lines_max, by the indentation that clang-format gives them, from the first
// line of the signature: lambdas and loops are parts of theirs, and the lines of a table, which begins with `= {`, are
// not counted.
std::vector<Finding> find_long_functions(std::string_view text);

// The names in the code of a text; and the names that its comments write as calls, `name(`: each must be a name in some
// code. No call is the notation of a rounded value, fl(x).
std::set<std::string> find_names(std::string_view text);
std::vector<Finding> find_called_in_comments(std::string_view text);

// Registers and their instructions in code, however they are spelled: GNU's vector_size, and the names of immintrin.h.
std::vector<Finding> find_vector_types(std::string_view text);

std::size_t count_lines(std::string_view text);

}  // namespace ecods::tidy
