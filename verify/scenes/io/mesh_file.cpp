#include "scenes/io/mesh_file.hpp"

#include <array>
#include <string>
#include <utility>

#include "scenes/io/extension.hpp"
#include "scenes/io/mesh_soup.hpp"
#include "scenes/io/read_bytes.hpp"

namespace ecods::scenes {
namespace {

using Reader = MeshSoup (*)(const std::filesystem::path&, std::string_view);

Reader reader_of(const std::filesystem::path& file) {
    static constexpr std::array<std::pair<const char*, Reader>, 4> readers{
        {{".obj", read_obj}, {".off", read_off}, {".ply", read_ply}, {".stl", read_stl}}};
    const std::string extension = lower_extension(file);
    for (const auto& [name, reader] : readers) {
        if (extension == name) return reader;
    }
    return nullptr;
}

MeshSoup read_soup(const std::filesystem::path& file) {
    const Reader reader = reader_of(file);
    if (reader == nullptr) throw ReadError(file, "", "unknown kind of mesh file; known are .obj, .off, .ply and .stl");
    return reader(file, read_bytes(file));
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
    return reader_of(file) != nullptr;
}

std::shared_ptr<const Mesh> read_mesh_file(const std::filesystem::path& file, PolygonCounts* polygons) {
    MeshSoup soup = read_soup(file);
    if (polygons != nullptr) *polygons = soup.polygons;
    return make_mesh(file, "", std::move(soup));
}

std::vector<NamedMesh> read_mesh_parts(const std::filesystem::path& file, PolygonCounts* polygons) {
    MeshSoup soup = read_soup(file);
    if (polygons != nullptr) *polygons = soup.polygons;
    return make_part_meshes(file, std::move(soup));
}

}  // namespace ecods::scenes
