// Geomview OFF: "OFF", the numbers of vertices and faces, a line for each.
#include <fmt/format.h>

#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {
namespace {

// The header names what stands behind the coordinates in a vertex line; all but other dimensions can be skipped.
void check_header(const LineReader& reader) {
    std::string_view header = reader.words()[0];
    for (const std::string_view prefix : {"ST", "C", "N"}) {
        if (header.starts_with(prefix)) header.remove_prefix(prefix.size());
    }
    if (header != "OFF") reader.fail("the file does not begin with OFF (4OFF and nOFF are not supported)");
    if (reader.words().size() > 1 && reader.words()[1] == "BINARY") reader.fail("binary OFF is not supported");
}

}  // namespace

MeshSoup read_off(const std::filesystem::path& file, std::string_view text) {
    LineReader reader(file, text, {.comment = '#'});
    reader.require_line("OFF");
    check_header(reader);
    std::size_t first = 1;  // the counts may stand on the line of the header
    if (reader.words().size() == 1) {
        reader.require_line("the number of vertices");
        first = 0;
    }
    const std::int64_t vertex_count = reader.integer(first);
    const std::int64_t face_count = reader.integer(first + 1);
    if (vertex_count < 0 || face_count < 0) reader.fail("a count is negative");

    MeshSoup soup;
    for (std::int64_t i = 0; i < vertex_count; ++i) {
        reader.require_line(fmt::format("vertex {}", i));
        soup.vertices.push_back(reader.point(0));
    }
    std::vector<std::uint32_t> corners;
    for (std::int64_t i = 0; i < face_count; ++i) {
        reader.require_line(fmt::format("face {}", i));
        const std::int64_t corner_count = reader.integer(0);
        if (corner_count < 3) reader.fail("a face has fewer than three corners");
        corners.clear();
        for (std::int64_t k = 1; k <= corner_count; ++k) {
            const std::int64_t index = reader.integer(static_cast<std::size_t>(k));
            if (index < 0 || index >= vertex_count) {
                reader.fail(fmt::format("index {} is out of range: there are {} vertices", index, vertex_count));
            }
            corners.push_back(static_cast<std::uint32_t>(index));
        }
        soup.add_polygon(corners);
    }
    return soup;
}

}  // namespace ecods::scenes
