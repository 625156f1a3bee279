// Files that another file names: a mesh of a scene, a buffer of a glTF.
//
// A name is a path relative to the folder of the file that names it, or absolute. It may lead anywhere, upwards too
// ("../parts/a.bin"), as an assembly's parts often lie beside its folder. A file from a stranger can so name any file
// that its reader may read. It can only ask for a mesh in a known format, or for exactly byteLength bytes of geometry,
// but an error may say how long the file is. Hence NamedFiles::in_folder, which is --untrusted of the programs.
#pragma once

#include <filesystem>
#include <string>

namespace ecods::scenes {

class JsonPlace;

// Says which files a file may name: any that its reader may read, or only those in its folder and below.
enum class NamedFiles { anywhere, in_folder };

// True if the file is in the folder or below, by their paths without links, "." and "..". The file need not exist.
// False if that cannot be found out, as of links that lead to each other.
bool is_within(const std::filesystem::path& folder, const std::filesystem::path& file);

// The path of the file whose name stands at `place`. Throws ReadError at `place` for one that may not be named. No file
// is opened for that, and the error is the same whether there is one: who sent the names learns nothing about files
// elsewhere.
std::filesystem::path named_file(const JsonPlace& place, const std::string& name, NamedFiles allowed);

}  // namespace ecods::scenes
