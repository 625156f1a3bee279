// A query that was answered wrongly, as files: a scene that ecods_check and ecods_clash read, and a picture.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/mesh_pairs.hpp"

namespace ecods::fuzz {

struct WrongAnswer {
    std::string engine;
    std::string family;
    std::size_t query = 0;  // of the pairs
    bool touches = false;   // the oracle's answer
};

// Writes FOLDER/ENGINE-FAMILY-QUERY.json with bodies "a" and "b", and what was asked of whom as comments; and with
// `has_picture` the same as .png, by POV-Ray (none where that is missing). Makes the folder. Returns the scene's file.
// Throws std::runtime_error when it cannot be written.
std::filesystem::path dump(const WrongAnswer& wrong, const scenes::MeshPairs& pairs,
                           const std::filesystem::path& folder, bool has_picture);

}  // namespace ecods::fuzz
