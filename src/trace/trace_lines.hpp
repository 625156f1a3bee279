// A trace read line by line, word by word. Whatever is not as it must be is an InvalidTrace with its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "ecods/ids.hpp"
#include "ecods/pose.hpp"

namespace ecods {

class TraceLines {
  public:
    explicit TraceLines(std::istream& in) : in_(in) {}

    // Goes to the next line. False behind the last.
    bool next();

    // The next word of the line. `what` says what it should have been, should it be missing or something else.
    std::string_view word(const char* what);
    std::uint64_t hex(const char* what);
    std::uint64_t decimal(const char* what, std::uint64_t max);
    BodyId body();
    Vec3 point();
    Pose pose();

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

    std::istream& in_;
    std::string text_;
    std::string_view left_;  // of text_
    std::size_t number_ = 0;
};

}  // namespace ecods
