// A file in memory, and its text line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ecods/pose.hpp"
#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// The bytes of a regular file. Throws ReadError (no such file, not a regular file, not readable).
std::string read_bytes(const std::filesystem::path& file);

// Splits text into lines and lines into words, and names the line in errors. Refers to the text. Lines end with LF,
// CR LF or CR.
class LineReader {
  public:
    // What a format allows besides words; '\0' is nothing.
    struct Syntax {
        char comment = '\0';       // from here on, a line is dropped
        char continuation = '\0';  // at the end of a line, the next belongs to it
    };

    LineReader(const std::filesystem::path& file, std::string_view text, Syntax syntax)
        : file_(file), text_(text), syntax_(syntax) {}

    // Goes to the next line that has a word, and splits it at blanks. False at the end of the text.
    bool next_line();

    // As next_line, but the end of the text is an error: what was expected there?
    void require_line(const std::string& expected);

    const std::vector<std::string_view>& words() const noexcept { return words_; }
    std::size_t line() const noexcept { return line_; }          // 1-based; 0 before the first
    std::size_t position() const noexcept { return position_; }  // of the first byte after the line

    // Word `index` as a finite double, to the last bit; as a whole number; as three coordinates from there on.
    double number(std::size_t index) const;
    std::int64_t integer(std::size_t index) const;
    Vec3 point(std::size_t index) const;

    [[noreturn]] void fail(const std::string& text) const;

  private:
    bool split_line();

    std::filesystem::path file_;
    std::string_view text_;
    Syntax syntax_;
    std::size_t position_ = 0;
    std::size_t line_ = 0;
    std::vector<std::string_view> words_;
};

// The double nearest to a decimal; infinity beyond the largest one. "nan" and "inf" are numbers, too. False if the word
// is not one as a whole.
bool parse_number(std::string_view word, double& value);
bool parse_integer(std::string_view word, std::int64_t& value);

}  // namespace ecods::scenes
