#include <limits>
#include <utility>

#include "scenes/io/mesh_soup.hpp"
#include "scenes/io/used_vertices.hpp"

namespace ecods::scenes {
namespace {

struct Part {
    std::string name;
    std::vector<Triangle> triangles;
};

// The parts that have triangles, in the order of their first ones.
std::vector<Part> split(const MeshSoup& soup) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<Part> parts;
    std::vector<std::size_t> place_of(soup.part_names.size() + 1,
                                      none);  // in `parts`; the last is the part without name
    const auto add = [&](std::size_t part, std::size_t begin, std::size_t end) {
        if (begin == end) return;
        if (place_of[part] == none) {
            place_of[part] = parts.size();
            parts.push_back({part < soup.part_names.size() ? soup.part_names[part] : "", {}});
        }
        const auto first = soup.triangles.begin();
        auto& triangles = parts[place_of[part]].triangles;
        triangles.insert(triangles.end(), first + static_cast<std::ptrdiff_t>(begin),
                         first + static_cast<std::ptrdiff_t>(end));
    };
    add(soup.part_names.size(), 0, soup.runs.empty() ? soup.triangles.size() : soup.runs[0].first_triangle);
    for (std::size_t i = 0; i < soup.runs.size(); ++i) {
        const bool is_last = i + 1 == soup.runs.size();
        add(soup.runs[i].part, soup.runs[i].first_triangle,
            is_last ? soup.triangles.size() : soup.runs[i + 1].first_triangle);
    }
    return parts;
}

MeshSoup soup_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> corners;
    for (const Triangle& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
    const UsedVertices used(std::move(corners));
    MeshSoup soup;
    for (const std::uint32_t vertex : used.old_numbers()) soup.vertices.push_back(vertices[vertex]);
    for (const auto& [a, b, c] : triangles)
        soup.triangles.push_back({used.new_number(a), used.new_number(b), used.new_number(c)});
    return soup;
}

}  // namespace

std::vector<NamedMesh> make_part_meshes(const std::filesystem::path& file, MeshSoup soup) {
    const std::vector<Part> parts = split(soup);
    std::vector<NamedMesh> meshes;
    if (parts.size() <= 1) {
        meshes.push_back({parts.empty() ? "" : parts[0].name, make_mesh(file, "", std::move(soup))});
        return meshes;
    }
    for (const Part& part : parts) {
        meshes.push_back({part.name, make_mesh(file, part.name, soup_of(soup.vertices, part.triangles))});
    }
    return meshes;
}

}  // namespace ecods::scenes
