#include "scenes/io/text_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace ecods::scenes {
namespace {

constexpr std::string_view blanks = " \t\v\f";

// Binary junk is not printed in full.
std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return word.size() > 40 ? text + "..." : text;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw ReadError(file, "", "no such file");
    // A directory has no bytes, and a pipe might never end.
    if (!std::filesystem::is_regular_file(status)) throw ReadError(file, "", "not a regular file");
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw ReadError(file, "", "cannot be read");
    return bytes;
}

bool LineReader::next_line() {
    words_.clear();
    while (position_ < text_.size()) {
        const bool continues = split_line();
        if (!words_.empty() && !continues) return true;
    }
    return !words_.empty();
}

// Adds the words of one line of the text; true if the next line belongs to it.
bool LineReader::split_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
    std::string_view rest = text_.substr(position_, end - position_);
    position_ = std::min(text_.size(), end + (text_.substr(end, 2) == "\r\n" ? 2 : 1));
    ++line_;
    if (syntax_.comment != '\0') rest = rest.substr(0, rest.find(syntax_.comment));
    const bool continues = syntax_.continuation != '\0' && rest.ends_with(syntax_.continuation);
    if (continues) rest.remove_suffix(1);
    for (std::size_t begin = rest.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = rest.find_first_not_of(blanks)) {
        rest.remove_prefix(begin);
        words_.push_back(rest.substr(0, rest.find_first_of(blanks)));
        rest.remove_prefix(words_.back().size());
    }
    return continues;
}

void LineReader::require_line(const std::string& expected) {
    if (!next_line()) fail("the file ends where " + expected + " should be");
}

double LineReader::number(std::size_t index) const {
    if (index >= words_.size()) fail("a number is missing");
    double value = 0;
    if (!parse_number(words_[index], value) || !std::isfinite(value))
        fail(fmt::format("'{}' is not a finite number", shown(words_[index])));
    return value;
}

std::int64_t LineReader::integer(std::size_t index) const {
    if (index >= words_.size()) fail("a whole number is missing");
    std::int64_t value = 0;
    if (!parse_integer(words_[index], value)) fail(fmt::format("'{}' is not a whole number", shown(words_[index])));
    return value;
}

Vec3 LineReader::point(std::size_t index) const {
    return {number(index), number(index + 1), number(index + 2)};
}

void LineReader::fail(const std::string& text) const {
    throw ReadError(file_, fmt::format("line {}", line_), text);
}

bool parse_number(std::string_view word, double& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ptr != end || word.empty()) return false;
    // from_chars gives no value out of range, and does not say on which side. Below, zero is the nearest double.
    if (result.ec == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
    return result.ec != std::errc::invalid_argument;
}

bool parse_integer(std::string_view word, std::int64_t& value) {
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

}  // namespace ecods::scenes
