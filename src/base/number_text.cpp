#include "base/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace ecods {
namespace {

template <class Number, class... How>
void append_chars(std::string& text, Number x, How... how) {
    std::array<char, 40> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, how...).ptr;
    text.append(buffer.data(), end);
}

}  // namespace

// to_chars writes no 0x, and depends on no locale.
void append_hex(std::string& text, double x) {
    if (std::signbit(x)) text.push_back('-');
    text.append("0x");
    append_chars(text, std::abs(x), std::chars_format::hex);
}

void append_hex(std::string& text, std::uint64_t x) {
    append_chars(text, x, 16);
}

void append(std::string& text, std::uint64_t x) {
    append_chars(text, x);
}

}  // namespace ecods
