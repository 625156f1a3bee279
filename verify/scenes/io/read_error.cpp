#include "scenes/io/read_error.hpp"

#include <utility>

namespace ecods::scenes {
namespace {

std::string lines_of(const std::vector<ReadError>& errors) {
    std::string lines;
    for (const ReadError& error : errors) {
        if (!lines.empty()) lines += '\n';
        lines += error.what();
    }
    return lines;
}

// A zero byte would end the message, and a terminal would obey other control characters.
std::string printable(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    return text;
}

}  // namespace

ReadError::ReadError(const std::filesystem::path& file_, const std::string& place_, const std::string& text_)
    : std::runtime_error(printable(file_.string() + ": " + (place_.empty() ? "" : place_ + ": ") + text_)),
      file(file_),
      place(place_),
      text(text_) {}

ReadErrors::ReadErrors(std::vector<ReadError> errors_)
    : std::runtime_error(lines_of(errors_)), errors(std::move(errors_)) {}

}  // namespace ecods::scenes
