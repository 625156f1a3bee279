// A file in memory.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// The bytes of a regular file: as many as its size says when it is opened, so that memory and time are bounded. Pipes,
// devices and folders are not opened. Throws ReadError: no such file, a folder, not a regular file, not readable.
//
// Every file is read by this function, those that another file names too (a mesh of a scene, a buffer of a glTF). Such
// a name is a path relative to the file that names it. It may lead anywhere, upwards ("../parts/a.bin") and by an
// absolute path too: an assembly's parts often lie beside its folder. A file from a stranger can so name any file that
// its reader may read, but it can only ask for a mesh in a known format, or for exactly byteLength bytes of geometry.
std::string read_bytes(const std::filesystem::path& file);

// The same error for a file that cannot be opened, before anything is known of its kind.
void require_regular_file(const std::filesystem::path& file);

}  // namespace ecods::scenes
