// A file in memory.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// The bytes of a regular file: as many as its size says when it is opened, so that memory and time are bounded. Pipes,
// devices and folders are not opened. Throws ReadError: no such file, a folder, not a regular file, not readable.
//
// Every file is read by this function, those too that another file names (named_file.hpp).
std::string read_bytes(const std::filesystem::path& file);

// The same error for a file that cannot be opened, before anything is known of its kind.
void require_regular_file(const std::filesystem::path& file);

}  // namespace ecods::scenes
