#include "trace/trace_lines.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "ecods/error.hpp"

namespace ecods {
namespace {

// Returns a word in the form of error messages: quoted, shortened to 40 characters, with '?' for all but printable
// ASCII.
std::string quoted(std::string_view word) {
    std::string shown = "'";
    for (const char c : word.substr(0, 40)) shown.push_back(c >= ' ' && c <= '~' ? c : '?');
    return shown.append(word.size() > 40 ? "...'" : "'");
}

}  // namespace

bool TraceLines::next() {
    text_.clear();
    left_ = {};
    if (in_.eof()) return false;
    if (!in_) throw InvalidTrace(number_ + 1, "cannot be read");
    constexpr auto end = std::istream::traits_type::eof();
    std::streambuf& buffer = *in_.rdbuf();
    try {
        for (auto c = buffer.sbumpc(); c != '\n'; c = buffer.sbumpc()) {
            if (c == end && text_.empty()) return false;
            if (c == end) break;
            text_.push_back(std::istream::traits_type::to_char_type(c));
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {
        throw InvalidTrace(number_ + 1, "cannot be read");
    }
    ++number_;
    if (drops_cr_ && text_.ends_with('\r')) text_.pop_back();
    left_ = text_;
    return true;
}

std::string_view TraceLines::next_header() {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (!next()) return {};
    std::string_view line = rest();
    if (line.starts_with(mark)) line.remove_prefix(mark.size());
    drops_cr_ = line.ends_with('\r');
    if (drops_cr_) line.remove_suffix(1);
    return line;
}

std::string_view TraceLines::word(const char* what) {
    if (left_.empty()) fail(std::string(what) + " is missing");
    const std::size_t end = std::min(left_.find(' '), left_.size());
    const std::string_view word = left_.substr(0, end);
    left_.remove_prefix(std::min(end + 1, left_.size()));
    return word;
}

std::uint64_t TraceLines::hex(const char* what) {
    const std::string_view found = word(what);
    if (const auto number = parse_hex(found)) return *number;
    fail(quoted(found) + " is no hexadecimal number: " + what);
}

std::uint64_t TraceLines::decimal(const char* what, std::uint64_t max) {
    const std::string_view found = word(what);
    if (const auto number = parse_decimal(found, max)) return *number;
    fail(quoted(found) + " is no number up to " + std::to_string(max) + ": " + what);
}

TracedBody TraceLines::body() {
    const std::string_view found = word("a body");
    if (const auto body = parse_body(found)) return *body;
    fail(quoted(found) + " is no body");
}

double TraceLines::coordinate() {
    const std::string_view found = word("a coordinate");
    if (const auto number = parse_hex_double(found)) return *number;
    fail(quoted(found) + " is no finite hexadecimal floating-point number");
}

Vec3 TraceLines::point() {
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
}

Pose TraceLines::pose() {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) pose.R(row, column) = coordinate();
        pose.t[row] = coordinate();
    }
    return pose;
}

CollisionFilter TraceLines::filter() {
    const std::uint64_t groups = hex("groups");
    return {.groups = groups, .mask = hex("a mask")};
}

std::optional<double> TraceLines::clearance() {
    return skips("none") ? std::nullopt : std::optional(coordinate());
}

double TraceLines::number() {
    return skips("inf") ? std::numeric_limits<double>::infinity() : coordinate();
}

std::optional<CollisionFilter> TraceLines::optional_filter() {
    return skips("none") ? std::nullopt : std::optional(filter());
}

bool TraceLines::skips(std::string_view next_word) {
    if (left_.substr(0, left_.find(' ')) != next_word) return false;
    word("a word");
    return true;
}

std::string_view TraceLines::rest() {
    const std::string_view rest = left_;
    left_ = {};
    return rest;
}

void TraceLines::require_end() {
    if (!at_end()) fail(quoted(left_) + " is too much");
}

void TraceLines::require_next(std::string_view first_word) {
    if (!next())
        throw InvalidTrace(number_ + 1, "the trace ends where a line '" + std::string(first_word) + " ...' belongs");
    const std::string_view found = word("a line");
    if (found != first_word) fail(quoted(found) + " is where a line '" + std::string(first_word) + " ...' belongs");
}

void TraceLines::fail(const std::string& reason) const {
    throw InvalidTrace(number_, reason);
}

}  // namespace ecods
