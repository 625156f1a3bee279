// JSON whose errors say where: a value together with the file and the path that lead to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::scenes {

// Refers to the document and to the file's name; both must outlive it. All functions throw ReadError when the value is
// not what is asked for, naming a place such as "bodies[3].pose.R".
class JsonPlace {
  public:
    JsonPlace(const std::filesystem::path& file, const nlohmann::json& value, std::string path = {})
        : file_(&file), value_(&value), path_(std::move(path)) {}

    JsonPlace at(const std::string& key) const;                   // a member that must exist
    std::optional<JsonPlace> find(const std::string& key) const;  // a member that may exist
    std::vector<JsonPlace> elements() const;                      // of an array
    std::vector<JsonPlace> elements(std::size_t count) const;     // of an array of this size
    std::size_t size() const;                                     // of an array
    JsonPlace element(std::size_t index) const;                   // of an array that has it

    std::string text() const;     // not empty
    double number() const;        // the nearest double
    std::uint32_t index() const;  // a whole number of 32 bits
    std::uint64_t count() const;  // a whole number of 53 bits, as many as every program reads alike
    bool boolean() const;
    Vec3 point() const;

    // A misspelt key would be ignored in silence, so unknown ones are errors. Keys that begin with "_" are comments.
    void check_keys(std::initializer_list<const char*> known) const;

    [[noreturn]] void fail(const std::string& text) const;

    const std::string& path() const noexcept { return path_; }
    const nlohmann::json& value() const noexcept { return *value_; }

  private:
    const std::filesystem::path* file_;
    const nlohmann::json* value_;
    std::string path_;
};

// {"R": [[...], [...], [...]], "t": [...]}: three rows and a translation, each of which may be left out.
Pose read_pose(const JsonPlace& place);

// The mesh of "vertices": [[x, y, z], ...] and "triangles": [[i, j, k], ...] at the place.
std::shared_ptr<const Mesh> read_inline_mesh(const std::filesystem::path& file, const JsonPlace& place);

}  // namespace ecods::scenes
