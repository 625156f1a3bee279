// What the readers of mesh formats fill.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"
#include "scenes/io/text_file.hpp"

namespace ecods::scenes {

struct MeshSoup {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    // Cuts the polygon into a fan around its first corner. Three corners at least, which are valid indices.
    void add_polygon(std::span<const std::uint32_t> corners);
};

// One per format; the text is the whole file. Throw ReadError. A soup may come out empty.
MeshSoup read_obj(const std::filesystem::path& file, std::string_view text);
MeshSoup read_off(const std::filesystem::path& file, std::string_view text);
MeshSoup read_ply(const std::filesystem::path& file, std::string_view text);
MeshSoup read_stl(const std::filesystem::path& file, std::string_view text);

// The mesh of a soup. Throws ReadError at `place`, also for what Mesh::create refuses.
std::shared_ptr<const Mesh> make_mesh(const std::filesystem::path& file, const std::string& place, MeshSoup soup);

}  // namespace ecods::scenes
