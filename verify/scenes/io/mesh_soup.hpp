// What the readers of mesh formats fill.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "scenes/io/text_file.hpp"
#include "scenes/polygon/cut_polygon.hpp"
#include "scenes/polygon/polygon_counts.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

struct MeshSoup {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    // Parts have names, perhaps equal ones. From its first triangle to the next run's, a run belongs to one part; what
    // comes before all runs, to a part without a name.
    struct Run {
        std::size_t first_triangle = 0;
        std::size_t part = 0;  // in part_names
    };
    std::vector<std::string> part_names;
    std::vector<Run> runs;

    PolygonCounts polygons;

    // Cuts the polygon into triangles that cover it once (cut_polygon.hpp), and counts it. Three corners at least,
    // which are valid indices. `place()` says where it is in the file.
    template <class Place>
    void add_polygon(std::span<const std::uint32_t> corners, const Place& place) {
        if (cut_and_count(corners) == PolygonCut::crossing && polygons.crossing == 1) polygons.first_crossing = place();
    }

    // The fan around the first corner, whatever it covers.
    void add_fan(std::span<const std::uint32_t> corners);

    // Triangles from now on belong to this part.
    void begin_run(std::size_t part) { runs.push_back({triangles.size(), part}); }

  private:
    PolygonCut cut_and_count(std::span<const std::uint32_t> corners);
};

// One per format; the text is the whole file. Throw ReadError. A soup may come out empty.
MeshSoup read_obj(const std::filesystem::path& file, std::string_view text);
MeshSoup read_off(const std::filesystem::path& file, std::string_view text);
MeshSoup read_ply(const std::filesystem::path& file, std::string_view text);
MeshSoup read_stl(const std::filesystem::path& file, std::string_view text);

// The mesh of a soup, of all its parts. Throws ReadError at `place`, also for what Mesh::create refuses.
std::shared_ptr<const Mesh> make_mesh(const std::filesystem::path& file, const std::string& place, MeshSoup soup);

// A mesh for each part that has triangles, in the order of their first triangles. If that is one, it is the mesh of the
// soup; of several, each has the vertices that its triangles use, in the soup's order.
std::vector<NamedMesh> make_part_meshes(const std::filesystem::path& file, MeshSoup soup);

}  // namespace ecods::scenes
