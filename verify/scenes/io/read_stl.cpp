// STL, text and binary.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {
namespace {

constexpr std::size_t header_size = 84;    // 80 bytes of anything and the number of triangles
constexpr std::size_t triangle_size = 50;  // normal, three corners, two bytes of anything

template <class T>
T little_endian(std::string_view bytes, std::size_t position) {
    static_assert(sizeof(T) == 4);
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[position + i]);
    T value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

void add_triangle(MeshSoup& soup) {
    const auto end = static_cast<std::uint32_t>(soup.vertices.size());
    soup.triangles.push_back({end - 3, end - 2, end - 1});
}

MeshSoup read_binary(const std::filesystem::path& file, std::string_view bytes, std::size_t triangle_count) {
    MeshSoup soup;
    for (std::size_t i = 0; i < triangle_count; ++i) {
        for (std::size_t k = 3; k < 12; k += 3) {
            Vec3 point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t position = header_size + i * triangle_size + 4 * (k + axis);
                point[static_cast<Eigen::Index>(axis)] = static_cast<double>(little_endian<float>(bytes, position));
            }
            if (!point.allFinite()) throw ReadError(file, fmt::format("triangle {}", i), "a coordinate is not finite");
            soup.vertices.push_back(point);
        }
        add_triangle(soup);
    }
    return soup;
}

std::string lower(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

MeshSoup read_text(const std::filesystem::path& file, std::string_view text) {
    MeshSoup soup;
    std::size_t corners = 0;  // of the facet so far
    bool is_in_facet = false;
    bool is_in_solid = false;
    LineReader reader(file, text, {});
    while (reader.next_line()) {
        const std::string word = lower(reader.words()[0]);
        if (word == "solid" || word == "endsolid") {
            if (is_in_facet || is_in_solid == (word == "solid")) reader.fail(word + " is out of place");
            is_in_solid = word == "solid";
        } else if (word == "facet") {
            if (!is_in_solid || is_in_facet) reader.fail("facet is out of place");
            is_in_facet = true;
            corners = 0;
        } else if (word == "vertex") {
            if (!is_in_facet) reader.fail("vertex is out of place");
            soup.vertices.push_back(reader.point(1));
            ++corners;
        } else if (word == "endfacet") {
            if (!is_in_facet || corners != 3) reader.fail("a facet does not have three corners");
            add_triangle(soup);
            is_in_facet = false;
        } else if (word != "outer" && word != "endloop") {
            reader.fail("this is not a line of an STL file");
        }
    }
    if (is_in_solid) reader.fail("the file ends before endsolid");
    return soup;
}

}  // namespace

MeshSoup read_stl(const std::filesystem::path& file, std::string_view text) {
    // Binary files may begin with "solid", too; their size tells them.
    if (text.size() >= header_size) {
        const std::size_t triangle_count = little_endian<std::uint32_t>(text, 80);
        if (text.size() == header_size + triangle_count * triangle_size) return read_binary(file, text, triangle_count);
    }
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin != std::string_view::npos && lower(text.substr(begin, 5)) == "solid") return read_text(file, text);
    throw ReadError(file, "",
                    "neither a text STL (no solid) nor a binary one (the size does not fit the triangle count)");
}

}  // namespace ecods::scenes
