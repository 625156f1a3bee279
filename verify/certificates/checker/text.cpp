#include "text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <memory>

namespace certificate_checker {
namespace {

constexpr std::size_t file_bytes_max = std::size_t{1} << 30;

// The value of a lower-case hexadecimal digit; 16 if it is none.
constexpr auto digit_values = [] {
    std::array<std::uint8_t, 256> table{};
    table.fill(16);
    for (std::uint8_t k = 0; k < 16; ++k) table[static_cast<unsigned char>("0123456789abcdef"[k])] = k;
    return table;
}();
unsigned digit_value(char c) {
    return digit_values[static_cast<unsigned char>(c)];
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

// Takes -?0x[01](\.[0-9a-f]{1,13})?p[+-][0-9]{1,4} off the text, which must be a finite double exactly. False: the text
// does not begin so.
bool take_number(std::string_view& text, double& value) {
    const bool is_negative = take(text, '-');
    if (!text.starts_with("0x0") && !text.starts_with("0x1")) return false;
    std::uint64_t mantissa = digit_value(text[2]);
    text.remove_prefix(3);
    int exponent = 0;
    if (take(text, '.')) {
        std::size_t digits = 0;
        for (; digits < text.size() && digit_value(text[digits]) < 16; ++digits) {
            if (digits == 13) return false;
            mantissa = mantissa << 4 | digit_value(text[digits]);
        }
        if (digits == 0) return false;
        text.remove_prefix(digits);
        exponent = -4 * static_cast<int>(digits);
    }
    const bool is_less = text.starts_with("p-");
    if (!is_less && !text.starts_with("p+")) return false;
    text.remove_prefix(2);
    int power = 0;
    std::size_t digits = 0;
    for (; digits < text.size() && digit_value(text[digits]) < 10; ++digits) {
        if (digits == 4) return false;
        power = 10 * power + static_cast<int>(digit_value(text[digits]));
    }
    if (digits == 0) return false;
    text.remove_prefix(digits);
    exponent += is_less ? -power : power;
    const double whole = static_cast<double>(mantissa);  // below 2^53, so exactly
    if (exponent >= -1000 && exponent <= 900) {          // no product of it and 2^exponent is rounded
        value = whole * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
    } else {
        value = std::ldexp(whole, exponent);
        if (!std::isfinite(value) || std::ldexp(value, -exponent) != whole) return false;
    }
    if (is_negative) value = -value;
    return true;
}

}  // namespace

std::string read_file(const char* path, std::string_view beginning) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path, "rb"), &std::fclose);
    if (file == nullptr) throw Unreadable{"cannot be opened"};
    std::string bytes;
    for (std::size_t wanted = 1 << 16;; wanted = bytes.size()) {
        const std::size_t before = bytes.size();
        bytes.resize(before + wanted);
        bytes.resize(before + std::fread(bytes.data() + before, 1, wanted, file.get()));
        if (std::ferror(file.get()) != 0) throw Unreadable{"cannot be read"};
        if (!bytes.starts_with(beginning)) throw Unreadable{"does not begin as such a file does"};
        if (bytes.size() < before + wanted) return bytes;
        if (bytes.size() >= file_bytes_max) throw Unreadable{"is too large"};
    }
}

bool Text::skip_line() {
    line_ = fields_ = {};
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = rest_.find('\n');
    is_whole_ = end != std::string_view::npos;
    line_ = fields_ = rest_.substr(0, end);
    rest_.remove_prefix(is_whole_ ? end + 1 : rest_.size());
    return true;
}

bool Text::next_line() {
    const bool has_line = skip_line();
    if (!is_whole_) fail("the file ends within a line");
    return has_line;
}

void Text::require_line() {
    if (next_line()) return;
    ++number_;
    fail("the file ends too soon");
}

std::string_view Text::peek() const {
    return fields_.substr(0, fields_.find(' '));
}

std::string_view Text::word() {
    const std::string_view field = peek();
    if (field.empty()) fail("a field is missing");
    fields_.remove_prefix(field.size());
    if (take(fields_, ' ') && fields_.empty()) fail("a space at the end of the line");
    return field;
}

void Text::expect(std::string_view word_wanted) {
    if (word() != word_wanted) fail("expected: " + std::string(word_wanted));
}

std::uint32_t Text::count() {
    // Most fields are good.
    std::uint32_t good = 0;
    std::size_t size = 0;
    while (size < std::min<std::size_t>(fields_.size(), 9) && digit_value(fields_[size]) < 10) {
        good = 10 * good + digit_value(fields_[size++]);
    }
    if (size > 0 && (fields_[0] != '0' || size == 1)) {
        const bool is_last = size == fields_.size();
        if (is_last || (fields_[size] == ' ' && size + 1 < fields_.size())) {
            fields_.remove_prefix(is_last ? size : size + 1);
            return good;
        }
    }
    const std::string_view field = word();
    std::uint64_t value = 0;
    bool is_good = field.size() <= 10 && (field[0] != '0' || field.size() == 1);
    for (const char c : field) {
        is_good = is_good && digit_value(c) < 10;
        value = 10 * value + digit_value(c);
    }
    if (!is_good || value >> 32 != 0) fail("not a number below 2^32: " + std::string(field.substr(0, 40)));
    return static_cast<std::uint32_t>(value);
}

double Text::number() {
    std::string_view rest = fields_;
    double value = 0;
    if (take_number(rest, value)) {
        const bool is_last = rest.empty();
        if (is_last || (take(rest, ' ') && !rest.empty())) {
            fields_ = rest;
            return value;
        }
    }
    const std::string_view field = word();
    fail("not a finite double: " + std::string(field.substr(0, 40)));
}

double Text::distance() {
    if (peek().starts_with('-')) fail("a distance has no sign");
    return number();
}

std::uint64_t Text::bits() {
    const std::string_view field = word();
    std::uint64_t value = 0;
    bool is_good = field.size() <= 16;
    for (const char c : field) {
        is_good = is_good && digit_value(c) < 16;
        value = value << 4 | digit_value(c);
    }
    if (!is_good) fail("not a set of bits: " + std::string(field.substr(0, 40)));
    return value;
}

void Text::end_of_line() const {
    if (!fields_.empty()) fail("more than the line should hold");
}

}  // namespace certificate_checker
