// The errors of everything that reads files.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ecods::scenes {

// A file could not be read, or what it says makes no mesh or scene. what() is "FILE: PLACE: TEXT", or "FILE: TEXT".
class ReadError : public std::runtime_error {
  public:
    ReadError(const std::filesystem::path& file, const std::string& place, const std::string& text);

    std::filesystem::path file;
    std::string place;  // such as "line 12", "face 3" or "bodies[2].pose.R"; empty when it is the file as a whole
    std::string text;
};

// What is wrong with each of several files. what() has a line for each, in their order.
class ReadErrors : public std::runtime_error {
  public:
    explicit ReadErrors(std::vector<ReadError> errors);

    std::vector<ReadError> errors;  // not empty
};

}  // namespace ecods::scenes
