// The files of a report.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "programs/clash/report.hpp"
#include "scenes/io/named_file.hpp"

namespace ecods::clash {

struct Inputs {
    std::vector<Part> parts;  // ascending by name; without groups
    std::vector<FailedFile> failed;
    std::vector<std::string> notes;
    double reading_seconds = 0;  // what reading the files took, without finding solids
};

// Files as they are, and of folders the meshes and assemblies in them and in their folders (links to folders are not
// followed, other files are passed over, .json files too). Ascending, each path once. A path that is no folder is
// taken for a file. Throws scenes::ReadError for a folder that cannot be read, or in which there is no such file; or in
// which a link leads to a file outside of it, if it may not: a folder names its files.
std::vector<std::filesystem::path> find_files(const std::vector<std::filesystem::path>& given,
                                              scenes::NamedFiles allowed);

struct Reading {
    std::size_t jobs = 1;
    bool keeps_going = false;  // when a file cannot be read
    scenes::NamedFiles named_files = scenes::NamedFiles::anywhere;
};

// Reads all files (scene_file.hpp), and finds out which meshes bound solids. Scenes are as in frame 0. Throws
// scenes::ReadErrors with an error for each file that cannot be read; when it keeps going, they are in `failed`.
// Bodies of one mesh have one shape.
Inputs read_inputs(const std::vector<std::filesystem::path>& files, const Reading& reading);

}  // namespace ecods::clash
