#include "scenes/io/mesh_soup.hpp"

#include "ecods/error.hpp"

namespace ecods::scenes {

void MeshSoup::add_fan(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

PolygonCut MeshSoup::cut_and_count(std::span<const std::uint32_t> corners) {
    const PolygonCut cut = cut_polygon(vertices, corners, triangles);
    if (corners.size() == 3) return cut;
    ++polygons.polygons;
    if (cut == PolygonCut::ears) ++polygons.ears;
    if (cut == PolygonCut::crossing) ++polygons.crossing;
    if (!is_in_a_plane(vertices, corners)) ++polygons.in_no_plane;
    return cut;
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
