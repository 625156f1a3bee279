// Reads the text that ../README.md describes: lines of fields. Nothing here decides whether a certificate is true.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace certificate_checker {

// Why a certificate is refused, and at which line of its file.
struct Refusal {
    std::size_t line;
    std::string why;
};

// Thrown where the work of a file exceeds its budget (README.md, "Limits").
struct TooCostly {};
struct Budget {
    std::uint64_t left = 0;
    bool has_filter = true;  // doubles may be asked first
    void spend(std::uint64_t units) { units > left ? throw TooCostly{} : left -= units; }
};

// Why a file cannot be read.
struct Unreadable {
    std::string why;
};

// All bytes of a file. Throws Unreadable if it cannot be opened, does not begin with `beginning` or is larger than
// 1 GiB; of a file that begins otherwise, little is read.
std::string read_file(const char* path, std::string_view beginning = {});

// Walks over lines. Fields are read from the current line; each function throws Refusal if the line has no such field.
class Text {
  public:
    explicit Text(std::string_view text) : rest_(text) {}

    // Goes to the next line; false if there is none. Throws Refusal if the line does not end.
    bool next_line();
    // The same, but for lines that do not end.
    bool skip_line();
    // Goes to the next line and throws Refusal if there is none.
    void require_line();
    std::size_t line_number() const { return number_; }
    std::string_view line() const { return line_; }

    bool is_at_end() const { return fields_.empty(); }
    bool begins_with(char c) const { return fields_.starts_with(c); }  // the next field
    std::string_view peek() const;                                     // the next field, empty if there is none
    std::string_view word();
    void expect(std::string_view word);
    std::uint32_t count();
    double number();    // finite
    double distance();  // finite, without a sign
    std::uint64_t bits();
    void end_of_line() const;

    [[noreturn]] void fail(std::string why) const { throw Refusal{number_, std::move(why)}; }

  private:
    std::string_view rest_;    // behind the current line
    std::string_view line_;    // without its LF
    std::string_view fields_;  // what is not read yet
    std::size_t number_ = 0;
    bool is_whole_ = true;  // the current line ends
};

}  // namespace certificate_checker
