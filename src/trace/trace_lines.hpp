// Reads a trace line by line, and each line word by word. Malformed text throws InvalidTrace with the line's number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/pose.hpp"
#include "ecods/world_options.hpp"
#include "trace/trace_text.hpp"

namespace ecods {

class TraceLines {
  public:
    explicit TraceLines(std::istream& in, std::size_t lines_before = 0) : in_(in), number_(lines_before) {}

    // Goes to the next line; returns false after the last one. Reads the stream's buffer directly, so flags, width and
    // locale of the stream have no effect. Throws std::bad_alloc if memory runs out.
    bool next();

    // Goes to the first line, and returns it without a byte order mark of UTF-8; an empty text if there is no line. If
    // the line ends with CR LF, as some editors write it, CR is dropped from the end of every line.
    std::string_view next_header();

    // The next functions read the next word or words of the line. These functions throw InvalidTrace if a word is
    // missing or malformed; `what` names the word in the error.
    std::string_view word(const char* what);
    std::uint64_t hex(const char* what);
    std::uint64_t decimal(const char* what, std::uint64_t max);
    TracedBody body();
    double coordinate();
    Vec3 point();
    Pose pose();
    CollisionFilter filter();
    std::optional<double> clearance();
    double number();  // 0 or more, infinity included
    std::optional<CollisionFilter> optional_filter();

    std::string_view rest();  // the rest of the line; nothing is left afterwards
    bool rest_is(std::string_view text) const noexcept { return left_ == text; }
    bool at_end() const noexcept { return left_.empty(); }
    void require_end();

    // Goes to the next line, which must continue the line before. Throws InvalidTrace unless that line exists and
    // begins with `first_word`; reads the word.
    void require_next(std::string_view first_word);

    std::size_t number() const noexcept { return number_; }  // number of the current line, from 1
    [[noreturn]] void fail(const std::string& reason) const;

  private:
    bool skips(std::string_view next_word);  // if the next word is `next_word`, skips it and returns true

    std::istream& in_;
    std::string text_;
    std::string_view left_;  // rest of the current line, in text_
    std::size_t number_;
    bool drops_cr_ = false;  // true if lines end with CR LF
};

}  // namespace ecods
