// JSON text as a document.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// The limit of open lists and objects. Files of scenes need 20 at most, and a document is taken apart by recursion.
constexpr std::size_t json_depth_max = 1000;

// A document whose end needs no memory. That of nlohmann::json asks for some, and ends the program where there is none.
class JsonDocument {
  public:
    JsonDocument() = default;
    ~JsonDocument();
    JsonDocument(JsonDocument&&) = default;
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    const nlohmann::json& operator*() const noexcept { return value_; }
    nlohmann::json& operator*() noexcept { return value_; }  // for its maker

  private:
    nlohmann::json value_;
};

// Makes the document of a text, in time and memory proportional to the text (times the logarithm of the number of an
// object's keys). Throws ReadError with the line for text that is not JSON, for a number beyond the largest double, for
// lists and objects deeper in each other than json_depth_max, and for a key that an object has twice: the standard
// leaves open which of its values counts, so no choice is made.
JsonDocument parse_json(const std::filesystem::path& file, std::string_view text);

// Reads the file and makes the document of its text. Throws as parse_json() and read_bytes() do.
JsonDocument read_json(const std::filesystem::path& file);

}  // namespace ecods::scenes
