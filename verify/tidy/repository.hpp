// The files of this repository.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ecods::tidy {

namespace fs = std::filesystem;

inline const fs::path root = ECODS_SOURCE_DIR;

inline std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace ecods::tidy
