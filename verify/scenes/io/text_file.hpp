// Text line by line.
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

// Splits text into lines and lines into words, and names the line in errors. Refers to the text. Lines end with LF,
// CR LF or CR.
class LineReader {
  public:
    // What a format allows besides words; '\0' is nothing.
    struct Syntax {
        char comment = '\0';           // a word that begins with it begins a comment, which ends with the line
        char continuation = '\0';      // at the end of a line, the next belongs to it
        bool comment_in_word = false;  // a comment may begin within a word, which then ends there
    };

    // The text begins after `lines_before` lines of the file. A byte order mark of UTF-8 is passed over at the
    // beginning of a file; one of UTF-16 is a ReadError.
    LineReader(const std::filesystem::path& file, std::string_view text, Syntax syntax, std::size_t lines_before = 0);

    // Goes to the next line that has a word, and splits it at blanks. False at the end of the text.
    bool next_line();

    // As next_line, but the end of the text is an error: what was expected there?
    void require_line(const std::string& expected);

    const std::vector<std::string_view>& words() const noexcept { return words_; }
    std::size_t line() const noexcept { return line_; }          // 1-based; lines_before, before the first
    std::size_t position() const noexcept { return position_; }  // of the first byte after the line

    // Word `index` as a finite double, to the last bit; as a whole number; as three coordinates from there on.
    double number(std::size_t index) const;
    std::int64_t integer(std::size_t index) const;
    Vec3 point(std::size_t index) const;

    // Reads a number as number() does, and takes infinite ones and those that are none ("nan"), too.
    double any_number(std::size_t index) const;

    // It is an error if the line has more words than that: nothing on it is passed over in silence.
    void require_end(std::size_t word_count) const;

    // The words from `index` on, with single blanks between them. A comment is taken for a part of the name ("part #3")
    // unless a blank follows its sign: a name that is cut could become that of another part.
    std::string name(std::size_t index) const;

    std::string place() const;  // "line 7"
    [[noreturn]] void fail(const std::string& text) const;

  private:
    bool split_line();

    std::filesystem::path file_;
    std::string_view text_;
    Syntax syntax_;
    std::size_t position_ = 0;
    std::size_t line_;
    std::vector<std::string_view> words_;
    std::string_view comment_;  // behind the words, its sign included
};

// The size of the byte order mark of UTF-8 that the text begins with, or 0.
std::size_t mark_size(std::string_view text);

// A word for a message. Binary junk is not printed in full.
std::string shown(std::string_view word);

}  // namespace ecods::scenes
