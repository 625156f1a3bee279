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

// Line by line: each says which may follow it.
class TextReader {
  public:
    TextReader(const std::filesystem::path& file, std::string_view text) : reader_(file, text, {}) {}

    MeshSoup read() {
        while (reader_.next_line()) read_line(lower(reader_.words()[0]));
        if (place_ != Place::file) reader_.fail("the file ends before endsolid");
        return std::move(soup_);
    }

  private:
    enum class Place { file, solid, facet, loop, behind_loop };

    void read_line(const std::string& word) {
        if (word == "solid") {
            go(word, Place::file, Place::solid);
            begin_solid();
        } else if (word == "endsolid") {
            go(word, Place::solid, Place::file);
        } else if (word == "facet") {
            go(word, Place::solid, Place::facet);
            read_normal();
        } else if (word == "outer") {
            go(word, Place::facet, Place::loop);
            if (reader_.words().size() < 2 || lower(reader_.words()[1]) != "loop") reader_.fail("outer is not a loop");
            reader_.require_end(2);
            corners_ = 0;
        } else if (word == "vertex") {
            go(word, Place::loop, Place::loop);
            soup_.vertices.push_back(reader_.point(1));
            reader_.require_end(4);
            ++corners_;
        } else if (word == "endloop") {
            go(word, Place::loop, Place::behind_loop);
            reader_.require_end(1);
            if (corners_ != 3) reader_.fail("a facet does not have three corners");
            add_triangle(soup_);
        } else if (word == "endfacet") {
            go(word, Place::behind_loop, Place::solid);
            reader_.require_end(1);
        } else {
            reader_.fail("this is not a line of an STL file");
        }
    }

    void go(const std::string& word, Place from, Place to) {
        if (place_ != from) reader_.fail(word + " is out of place");
        place_ = to;
    }

    // Every solid is a part, those that are named alike too.
    void begin_solid() {
        const std::string name = reader_.name(1);
        soup_.part_names.push_back(name.empty() ? fmt::format("solid {}", soup_.part_names.size() + 1) : name);
        soup_.begin_run(soup_.part_names.size() - 1);
    }

    // Its numbers are not looked at: some programs write "-1.#IND" there.
    void read_normal() {
        if (reader_.words().size() < 5 || lower(reader_.words()[1]) != "normal") reader_.fail("a facet has no normal");
        reader_.require_end(5);
    }

    LineReader reader_;
    MeshSoup soup_;
    Place place_ = Place::file;
    std::size_t corners_ = 0;  // of the loop so far
};

}  // namespace

MeshSoup read_stl(const std::filesystem::path& file, std::string_view text) {
    // Binary files may begin with "solid", too; their size gives them away.
    if (text.size() >= header_size) {
        const std::size_t triangle_count = little_endian<std::uint32_t>(text, 80);
        if (text.size() == header_size + triangle_count * triangle_size) return read_binary(file, text, triangle_count);
    }
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin != std::string_view::npos && lower(text.substr(begin, 5)) == "solid")
        return TextReader(file, text).read();
    throw ReadError(file, "",
                    "neither a text STL (no solid) nor a binary one (the size does not fit the triangle count)");
}

}  // namespace ecods::scenes
