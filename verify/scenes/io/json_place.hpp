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
#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {

// A place refers to a document of parse_json() and to the file's name; both must outlive it, and the document must not
// change. It is three pointers: the path that an error names, such as "bodies[3].pose.R", is searched for in the
// document when there is an error. All functions throw ReadError when the value is not what is asked for.
class JsonPlace {
  public:
    JsonPlace(const std::filesystem::path& file, const nlohmann::json& document)
        : file_(&file), document_(&document), value_(&document) {}

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

    const std::filesystem::path& file() const noexcept { return *file_; }
    const nlohmann::json& value() const noexcept { return *value_; }

  private:
    JsonPlace within(const nlohmann::json& value) const;

    const std::filesystem::path* file_;
    const nlohmann::json* document_;
    const nlohmann::json* value_;
};

// The mesh of a soup that was read at the place, where the error is if there is none.
std::shared_ptr<const Mesh> make_mesh(const JsonPlace& place, MeshSoup soup);

// {"R": [[...], [...], [...]], "t": [...]}: three rows and a translation, each of which may be left out.
Pose read_pose(const JsonPlace& place);

// {"q": [w, x, y, z]} or {"axis": [x, y, z], "degrees": number}, of which "degrees" may be "angle", in radians. A
// "pivot" that is left out is the origin, and a "pivot_to" the pivot: the body does not glide.
Turn read_turn(const JsonPlace& place);

// The mesh of "vertices": [[x, y, z], ...] and "triangles": [[i, j, k], ...] at the place.
std::shared_ptr<const Mesh> read_inline_mesh(const JsonPlace& place);

}  // namespace ecods::scenes
