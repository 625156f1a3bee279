// STL, text and binary.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
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

// Word by word, over the ends of lines: each keyword says which may follow it.
class TextReader {
  public:
    TextReader(const std::filesystem::path& file, std::string_view text) : file_(file), reader_(file, text, {}) {}

    MeshSoup read() {
        while (has_word()) read_item(lower(reader_.words()[next_++]));
        if (place_ != Place::file) reader_.fail("the file ends before endsolid");
        return std::move(soup_);
    }

  private:
    enum class Place { file, solid, facet, loop, behind_loop };

    // Goes on to the next line where this one ends. False at the end of the file.
    bool has_word() {
        if (next_ < reader_.words().size()) return true;
        next_ = 0;
        return reader_.next_line();
    }

    void read_item(const std::string& word) {
        if (word == "solid") {
            go(word, Place::file, Place::solid);
            begin_solid();
        } else if (word == "endsolid") {
            go(word, Place::solid, Place::file);
            read_name();
            if (next_ < reader_.words().size()) reader_.fail("facet is out of place");
        } else if (word == "facet") {
            go(word, Place::solid, Place::facet);
            read_normal();
        } else if (word == "outer") {
            go(word, Place::facet, Place::loop);
            if (lower(next_word("outer is not a loop")) != "loop") reader_.fail("outer is not a loop");
            corners_ = 0;
        } else if (word == "vertex") {
            go(word, Place::loop, Place::loop);
            read_vertex();
            ++corners_;
        } else if (word == "endloop") {
            go(word, Place::loop, Place::behind_loop);
            if (corners_ != 3) reader_.fail("a facet does not have three corners");
            add_triangle(soup_);
        } else if (word == "endfacet") {
            go(word, Place::behind_loop, Place::solid);
        } else if (next_ > 1) {
            reader_.fail(fmt::format("'{}' is one word too many", shown(reader_.words()[next_ - 1])));
        } else {
            reader_.fail("this is not a line of an STL file");
        }
    }

    void go(const std::string& word, Place from, Place to) {
        if (place_ != from) reader_.fail(word + " is out of place");
        place_ = to;
    }

    // The error names the line that ends where the word should be.
    std::string_view next_word(const char* error) {
        if (next_ == reader_.words().size()) {
            const std::string place = reader_.place();
            if (!has_word() || is_keyword(lower(reader_.words()[0]))) throw ReadError(file_, place, error);
        }
        return reader_.words()[next_++];
    }

    static bool is_keyword(std::string_view word) {
        constexpr std::array<std::string_view, 7> keywords{"solid",  "endsolid", "facet",   "outer",
                                                           "vertex", "endloop",  "endfacet"};
        return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
    }

    // Up to the end of the line, or to "facet normal".
    std::string read_name() {
        const auto& words = reader_.words();
        std::string name;
        for (; next_ < words.size(); ++next_) {
            const bool is_facet =
                next_ + 1 < words.size() && lower(words[next_]) == "facet" && lower(words[next_ + 1]) == "normal";
            if (is_facet) break;
            if (!name.empty()) name += ' ';
            name += words[next_];
        }
        return name;
    }

    // Every solid is a part, those that are named alike too.
    void begin_solid() {
        const std::string name = read_name();
        soup_.part_names.push_back(name.empty() ? fmt::format("solid {}", soup_.part_names.size() + 1) : name);
        soup_.begin_run(soup_.part_names.size() - 1);
    }

    // Its numbers are not looked at: some programs write "-1.#IND" there.
    void read_normal() {
        constexpr const char* error = "a facet has no normal";
        if (lower(next_word(error)) != "normal") reader_.fail(error);
        for (int i = 0; i < 3; ++i) {
            if (is_keyword(lower(next_word(error)))) reader_.fail(error);
        }
    }

    void read_vertex() {
        Vec3 point;
        for (double& x : point) {
            next_word("a number is missing");
            x = reader_.number(next_ - 1);
        }
        soup_.vertices.push_back(point);
    }

    std::filesystem::path file_;
    LineReader reader_;
    std::size_t next_ = 0;  // of the words of the line
    MeshSoup soup_;
    Place place_ = Place::file;
    std::size_t corners_ = 0;  // of the loop so far
};

[[noreturn]] void fail_by_size(const std::filesystem::path& file, std::size_t size, std::size_t triangle_count) {
    const std::size_t expected = header_size + triangle_count * triangle_size;
    const std::size_t difference = size > expected ? size - expected : expected - size;
    throw ReadError(file, "",
                    fmt::format("neither a text STL nor a binary one: the file has {} bytes, and its count of {} "
                                "triangles asks for {}: {} bytes too {}",
                                size, triangle_count, expected, difference, size > expected ? "many" : "few"));
}

}  // namespace

MeshSoup read_stl(const std::filesystem::path& file, std::string_view text) {
    // Binary files may begin with "solid", too; their size and their zero bytes give them away.
    const bool has_header = text.size() >= header_size;
    const std::size_t triangle_count = has_header ? little_endian<std::uint32_t>(text, 80) : 0;
    if (has_header && text.size() == header_size + triangle_count * triangle_size)
        return read_binary(file, text, triangle_count);
    const std::size_t begin = text.find_first_not_of(" \t\r\n", mark_size(text));
    const bool is_text = begin != std::string_view::npos && lower(text.substr(begin, 5)) == "solid";
    if (has_header && (!is_text || text.find('\0') != std::string_view::npos))
        fail_by_size(file, text.size(), triangle_count);
    if (is_text) return TextReader(file, text).read();
    throw ReadError(file, "", "neither a text STL (no solid) nor a binary one (no header of 84 bytes)");
}

}  // namespace ecods::scenes
