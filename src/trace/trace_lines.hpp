// A trace read line by line, word by word. Text that is not as it must be is an InvalidTrace with its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/collision_filter.hpp"
#include "ecods/pose.hpp"
#include "trace/trace_text.hpp"

namespace ecods {

class TraceLines {
  public:
    explicit TraceLines(std::istream& in, std::size_t lines_before = 0) : in_(in), number_(lines_before) {}

    // Goes to the next line. False behind the last. Reads from the stream's buffer: no flag, width or locale of the
    // stream has a part in it, and where memory runs out, std::bad_alloc is thrown.
    bool next();

    // Goes to the first line, and returns whether it is this one. It may begin with the byte order mark of UTF-8. If it
    // ends with CR LF, so does each line: an editor wrote them, and the CR belongs to no line.
    bool next_is_header(std::string_view header);

    // The next word of the line. `what` names it in the error that is thrown where it is missing or another.
    std::string_view word(const char* what);
    std::uint64_t hex(const char* what);
    std::uint64_t decimal(const char* what, std::uint64_t max);
    TracedBody body();
    Vec3 point();
    Pose pose();
    CollisionFilter filter();
    std::optional<double> clearance();
    double number();  // from 0, infinity included
    std::optional<CollisionFilter> optional_filter();

    std::string_view rest();  // of the line, which is then at its end
    bool rest_is(std::string_view text) const noexcept { return left_ == text; }
    bool at_end() const noexcept { return left_.empty(); }
    void require_end();

    // A line that belongs to the one before it, and begins with this word.
    void require_next(std::string_view first_word);

    std::size_t number() const noexcept { return number_; }  // from 1
    [[noreturn]] void fail(const std::string& reason) const;

  private:
    double coordinate();
    bool skips(std::string_view next_word);  // if it is the next word

    std::istream& in_;
    std::string text_;
    std::string_view left_;  // of text_
    std::size_t number_;
    bool drops_cr_ = false;  // from the end of each line
};

}  // namespace ecods
