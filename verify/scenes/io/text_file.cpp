#include "scenes/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/io/parse_number.hpp"

namespace ecods::scenes {
namespace {

constexpr std::string_view blanks = " \t\v\f";

}  // namespace

std::size_t mark_size(std::string_view text) {
    return text.starts_with("\xef\xbb\xbf") ? 3 : 0;
}

std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return word.size() > 40 ? text + "..." : text;
}

LineReader::LineReader(const std::filesystem::path& file, std::string_view text, Syntax syntax,
                       std::size_t lines_before)
    : file_(file), text_(text), syntax_(syntax), line_(lines_before) {
    if (lines_before > 0) return;
    position_ = mark_size(text);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw ReadError(file, "line 1", "the text is UTF-16; UTF-8 or plain ASCII is read");
}

bool LineReader::next_line() {
    words_.clear();
    comment_ = {};
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
    bool continues = syntax_.continuation != '\0' && rest.ends_with(syntax_.continuation);
    if (continues) rest.remove_suffix(1);
    for (std::size_t begin = rest.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = rest.find_first_not_of(blanks)) {
        rest.remove_prefix(begin);
        if (syntax_.comment != '\0' && rest[0] == syntax_.comment) {
            comment_ = rest.substr(0, rest.find_last_not_of(blanks) + 1);
            return false;
        }
        std::size_t end_of_word = rest.find_first_of(blanks);
        if (syntax_.comment_in_word) end_of_word = std::min(end_of_word, rest.find(syntax_.comment));
        words_.push_back(rest.substr(0, end_of_word));
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

double LineReader::any_number(std::size_t index) const {
    if (index >= words_.size()) fail("a number is missing");
    double value = 0;
    if (!parse_number(words_[index], value)) fail(fmt::format("'{}' is not a number", shown(words_[index])));
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

void LineReader::require_end(std::size_t word_count) const {
    if (words_.size() > word_count) fail(fmt::format("'{}' is one word too many", shown(words_[word_count])));
}

std::string LineReader::name(std::size_t index) const {
    std::string name;
    for (std::size_t i = index; i < words_.size(); ++i) {
        if (!name.empty()) name += ' ';
        name += words_[i];
    }
    const bool is_number_sign = comment_.size() > 1 && blanks.find(comment_[1]) == std::string_view::npos;
    if (!is_number_sign) return name;
    if (!name.empty()) name += ' ';
    return name.append(comment_);
}

std::string LineReader::place() const {
    return fmt::format("line {}", line_);
}

void LineReader::fail(const std::string& text) const {
    throw ReadError(file_, place(), text);
}

}  // namespace ecods::scenes
