// JSON text as a document.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// Throws ReadError with the line for text that is not JSON, for a number beyond the largest double and for a key that
// an object has twice: the standard leaves open which of its values counts, so no choice is made. Any depth will do.
nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text);

// The same of the file as a whole.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace ecods::scenes
