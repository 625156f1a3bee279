// Geomview OFF: "OFF", the numbers of vertices and faces, a line for each.
#include <fmt/format.h>

#include <algorithm>

#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {
namespace {

// How many numbers stand in the line of a vertex. A colour has three or four.
struct VertexSize {
    std::size_t min = 3;
    std::size_t max = 3;
};

// The header names what stands behind the coordinates: normals, colours, texture coordinates.
VertexSize read_header(const LineReader& reader) {
    std::string_view header = reader.words()[0];
    VertexSize size;
    const auto skip = [&](std::string_view prefix, std::size_t min, std::size_t max) {
        if (!header.starts_with(prefix)) return;
        header.remove_prefix(prefix.size());
        size = {size.min + min, size.max + max};
    };
    skip("ST", 2, 2);
    skip("C", 3, 4);
    skip("N", 3, 3);
    if (header != "OFF") reader.fail("the file does not begin with OFF (4OFF and nOFF are not supported)");
    if (reader.words().size() > 1 && reader.words()[1] == "BINARY") reader.fail("binary OFF is not supported");
    return size;
}

void read_vertex(const LineReader& reader, const VertexSize& size, MeshSoup& soup) {
    soup.vertices.push_back(reader.point(0));
    for (std::size_t i = 3; i < std::max(size.min, reader.words().size()); ++i) reader.number(i);
    reader.require_end(size.max);
}

// The corners, and perhaps a colour: the number of one, or its three or four components.
void read_face(const LineReader& reader, std::int64_t vertex_count, MeshSoup& soup) {
    const std::int64_t corner_count = reader.integer(0);
    if (corner_count < 3) reader.fail("a face has fewer than three corners");
    std::vector<std::uint32_t> corners;
    for (std::int64_t k = 1; k <= corner_count; ++k) {
        const std::int64_t index = reader.integer(static_cast<std::size_t>(k));
        if (index < 0 || index >= vertex_count) {
            reader.fail(fmt::format("index {} is out of range: there are {} vertices", index, vertex_count));
        }
        corners.push_back(static_cast<std::uint32_t>(index));
    }
    const std::size_t end = corners.size() + 1;
    for (std::size_t i = end; i < reader.words().size(); ++i) reader.number(i);
    if (reader.words().size() == end + 2) reader.fail("two numbers behind the corners are no colour");
    reader.require_end(end + 4);
    soup.add_polygon(corners);
}

}  // namespace

MeshSoup read_off(const std::filesystem::path& file, std::string_view text) {
    LineReader reader(file, text, {.comment = '#'});
    reader.require_line("OFF");
    const VertexSize size = read_header(reader);
    std::size_t first = 1;  // the counts may stand on the line of the header
    if (reader.words().size() == 1) {
        reader.require_line("the number of vertices");
        first = 0;
    }
    const std::int64_t vertex_count = reader.integer(first);
    const std::int64_t face_count = reader.integer(first + 1);
    if (vertex_count < 0 || face_count < 0) reader.fail("a count is negative");
    if (reader.words().size() > first + 2) reader.integer(first + 2);  // edges, which are not given
    reader.require_end(first + 3);

    MeshSoup soup;
    for (std::int64_t i = 0; i < vertex_count; ++i) {
        reader.require_line(fmt::format("vertex {}", i));
        read_vertex(reader, size, soup);
    }
    for (std::int64_t i = 0; i < face_count; ++i) {
        reader.require_line(fmt::format("face {}", i));
        read_face(reader, vertex_count, soup);
    }
    if (reader.next_line()) reader.fail("the file goes on behind the last face");
    return soup;
}

}  // namespace ecods::scenes
