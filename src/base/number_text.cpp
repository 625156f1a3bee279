#include "base/number_text.hpp"

#include <array>
#include <bit>
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

// Reads the bits of x, because std::to_chars writes a subnormal number as zero if the processor takes it for zero.
void append_hex(std::string& text, double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t fraction = bits << 12;
    text.append(bits >> 63 != 0 ? "-0x" : "0x");
    if (biased == 0x7ff) return append_chars(text, std::abs(x), std::chars_format::hex);
    text.push_back(biased == 0 ? '0' : '1');
    if (fraction != 0) text.push_back('.');
    for (; fraction != 0; fraction <<= 4) text.push_back("0123456789abcdef"[fraction >> 60]);
    const bool is_zero = bits << 1 == 0;
    const int exponent = is_zero ? 0 : biased == 0 ? -1022 : biased - 1023;
    text.append(exponent < 0 ? "p" : "p+");
    append_chars(text, exponent);
}

void append_hex(std::string& text, std::uint64_t x) {
    append_chars(text, x, 16);
}

void append(std::string& text, std::uint64_t x) {
    append_chars(text, x);
}

std::string decimal_text(double x) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
    return {buffer.data(), end};
}

}  // namespace ecods
