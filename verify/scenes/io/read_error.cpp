#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

ReadError::ReadError(const std::filesystem::path& file_, const std::string& place_, const std::string& text_)
    : std::runtime_error(file_.string() + ": " + (place_.empty() ? "" : place_ + ": ") + text_),
      file(file_),
      place(place_),
      text(text_) {}

}  // namespace ecods::scenes
