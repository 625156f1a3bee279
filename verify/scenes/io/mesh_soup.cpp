#include "scenes/io/mesh_soup.hpp"

#include "ecods/error.hpp"

namespace ecods::scenes {

void MeshSoup::add_polygon(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

std::shared_ptr<const Mesh> make_mesh(const std::filesystem::path& file, const std::string& place, MeshSoup soup) {
    if (soup.triangles.empty()) throw ReadError(file, place, "there is no triangle: the mesh is empty");
    try {
        return Mesh::create(std::move(soup.vertices), std::move(soup.triangles));
    } catch (const Error& error) {
        throw ReadError(file, place, error.what());
    }
}

}  // namespace ecods::scenes
