#include "process/csv_field.hpp"

#include <algorithm>
#include <array>

namespace ecods::process {
namespace {

// The ASCII characters, and those of Unicode's full-width and small forms that stand for them.
constexpr std::array<std::string_view, 12> formula_starts = {
    "=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20", "\uFE66", "\uFE62", "\uFE63", "\uFE6B"};
constexpr std::string_view separators = ",;\t|\n\r\v\f";

// Spaces of any width, of no width, and the mark of the byte order.
constexpr std::array<std::string_view, 8> wide_blanks = {"\u00A0", "\u2007", "\u202F", "\u3000",
                                                         "\u200B", "\u200E", "\u2060", "\uFEFF"};

// The size of the first of the words that the text begins with; 0 if there is none.
template <std::size_t n>
std::size_t prefix_size(std::string_view text, const std::array<std::string_view, n>& words) {
    const auto found = std::ranges::find_if(words, [&](std::string_view word) { return text.starts_with(word); });
    return found == words.end() ? 0 : found->size();
}

// The size of what may stand between the start of a cell and a formula; 0 if the text begins with something else.
std::size_t blank_size(std::string_view text) {
    const auto byte = static_cast<unsigned char>(text[0]);
    return byte <= ' ' || byte == 0x7F || byte == '"' ? 1 : prefix_size(text, wide_blanks);
}

std::string in_quotes(std::string_view text) {
    std::string field = "\"";
    for (const char c : text) field.append(c == '"' ? 2 : 1, c);
    return field + '"';
}

}  // namespace

std::string csv_field(std::string_view text) {
    const bool is_plain = text.find_first_of(",\"\r\n") == std::string_view::npos;
    return is_plain ? std::string(text) : in_quotes(text);
}

std::string csv_name(std::string_view text) {
    std::string guarded;
    bool is_start = true;  // of a cell, perhaps
    for (std::string_view rest = text; !rest.empty();) {
        std::size_t size = 1;
        if (separators.find(rest[0]) != std::string_view::npos) {
            is_start = true;
        } else if (const std::size_t blank = blank_size(rest); blank > 0) {
            size = blank;
        } else {
            if (is_start && prefix_size(rest, formula_starts) > 0) guarded += '\'';
            is_start = false;
        }
        guarded += rest.substr(0, size);
        rest.remove_prefix(size);
    }
    return guarded.size() == text.size() ? csv_field(text) : in_quotes(guarded);
}

}  // namespace ecods::process
