// Geomview OFF: "OFF", the numbers of vertices and faces, and then these.
#include <fmt/format.h>

#include <algorithm>

#include "scenes/io/mesh_soup.hpp"
#include "scenes/io/parse_number.hpp"

namespace ecods::scenes {
namespace {

// How many numbers stand behind the coordinates of a vertex. A colour has three or four.
struct ExtraSize {
    std::size_t min = 0;
    std::size_t max = 0;
};

// The numbers one by one, over the ends of lines; but some items end with their line.
class OffReader {
  public:
    OffReader(const std::filesystem::path& file, std::string_view text)
        : reader_(file, text, {.comment = '#', .comment_in_word = true}) {}

    MeshSoup read() {
        const ExtraSize extra = read_header();
        for (std::int64_t i = 0; i < vertex_count_; ++i) read_vertex(i, extra);
        for (std::int64_t i = 0; i < face_count_; ++i) read_face(i);
        if (reader_.next_line()) reader_.fail("the file goes on behind the last face");
        return std::move(soup_);
    }

  private:
    std::size_t left() const { return reader_.words().size() - next_; }  // words of the line

    // Goes on to the next line where this one ends. What is read there?
    void go_on(const char* item, std::int64_t index) {
        if (left() > 0) return;
        reader_.require_line(index < 0 ? item : fmt::format("{} {}", item, index));
        next_ = 0;
    }
    double next_number(const char* item, std::int64_t index) {
        go_on(item, index);
        return reader_.number(next_++);
    }
    std::int64_t next_integer(const char* item, std::int64_t index) {
        go_on(item, index);
        return reader_.integer(next_++);
    }

    // Its first word names what stands behind the coordinates: normals, colours, texture coordinates. The counts may
    // stand on its line, and the first of them so close behind it that it is a part of the word.
    ExtraSize read_header() {
        reader_.require_line("OFF");
        std::string_view header = reader_.words()[0];
        ExtraSize extra;
        const auto skip = [&](std::string_view prefix, std::size_t min, std::size_t max) {
            if (!header.starts_with(prefix)) return;
            header.remove_prefix(prefix.size());
            extra = {extra.min + min, extra.max + max};
        };
        skip("ST", 2, 2);
        skip("C", 3, 4);
        skip("N", 3, 3);
        const std::string_view count = header.substr(header.starts_with("OFF") ? 3 : 0);
        const bool is_glued = header.starts_with("OFF") && parse_integer(count, vertex_count_);
        if (header != "OFF" && !is_glued)
            reader_.fail("the file does not begin with OFF (4OFF and nOFF are not supported)");
        if (reader_.words().size() > 1 && reader_.words()[1] == "BINARY") reader_.fail("binary OFF is not supported");
        next_ = 1;
        if (!is_glued) vertex_count_ = next_integer("the number of vertices", -1);
        face_count_ = next_integer("the number of faces", -1);
        if (vertex_count_ < 0 || face_count_ < 0) reader_.fail("a count is negative");
        if (left() > 0) reader_.integer(next_++);  // edges, which are not given
        reader_.require_end(next_);
        return extra;
    }

    void read_vertex(std::int64_t index, const ExtraSize& extra) {
        Vec3 point;
        for (double& x : point) x = next_number("vertex", index);
        soup_.vertices.push_back(point);
        if (extra.max == 0 && left() >= 3) return;
        for (std::size_t k = 0; k < std::min(std::max(extra.min, left()), extra.max); ++k)
            reader_.any_number(next_ + k);
        reader_.require_end(next_ + extra.max);
        next_ = reader_.words().size();
    }

    // The corners, and perhaps a colour on the line of the last: the number of one, or its three or four components.
    void read_face(std::int64_t index) {
        const std::int64_t corner_count = next_integer("face", index);
        const std::string place = reader_.place();
        if (corner_count < 3) reader_.fail("a face has fewer than three corners");
        std::vector<std::uint32_t> corners;
        for (std::int64_t k = 0; k < corner_count; ++k) {
            const std::int64_t corner = next_integer("the rest of face", index);
            if (corner < 0 || corner >= vertex_count_) {
                reader_.fail(fmt::format("index {} is out of range: there are {} vertices", corner, vertex_count_));
            }
            corners.push_back(static_cast<std::uint32_t>(corner));
        }
        reader_.require_end(next_ + 4);
        for (std::size_t i = next_; i < reader_.words().size(); ++i) reader_.any_number(i);
        if (left() == 2) reader_.fail("two numbers behind the corners are no colour");
        next_ = reader_.words().size();
        soup_.add_polygon(corners, [&] { return place; });
    }

    LineReader reader_;
    std::size_t next_ = 0;  // of the words of the line
    std::int64_t vertex_count_ = 0, face_count_ = 0;
    MeshSoup soup_;
};

}  // namespace

MeshSoup read_off(const std::filesystem::path& file, std::string_view text) {
    return OffReader(file, text).read();
}

}  // namespace ecods::scenes
