// Wavefront OBJ: the lines "v x y z ..." and "f i/t/n j/t/n k/t/n ...", and the names of parts in "o" and "g".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "scenes/io/mesh_soup.hpp"
#include "scenes/io/parse_number.hpp"

namespace ecods::scenes {
namespace {

// They add no surface: normals, texture, appearance and smoothing; points and lines; curves and how they are made.
constexpr std::array<std::string_view, 35> ignored{
    "vt",     "vn",     "vp",    "p",    "l",        "s",        "mg",         "usemtl",    "mtllib",
    "usemap", "maplib", "bevel", "lod",  "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech",
    "stech",  "cstype", "deg",   "bmat", "step",     "curv",     "curv2",      "parm",      "trim",
    "hole",   "scrv",   "sp",    "end",  "con",      "cdc",      "cdp",        "res"};

// They would add surfaces, read other files or run commands.
constexpr std::array<std::string_view, 6> unsupported{"surf", "bsp", "bzp", "fo", "call", "csh"};

template <class List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// A corner "i", "i/t", "i//n" or "i/t/n". Indices count from 1; negative ones count back from the newest vertex.
std::uint32_t read_corner(const LineReader& reader, std::string_view word, std::size_t vertex_count) {
    std::int64_t index = 0;
    const std::size_t end = std::min(word.find('/'), word.size());
    if (!parse_integer(word.substr(0, end), index)) reader.fail("a corner is not a whole number");
    std::string_view rest = word.substr(end);
    for (int i = 0; i < 2 && rest.starts_with('/'); ++i) {
        const std::string_view number = rest.substr(1, rest.find('/', 1) - 1);
        std::int64_t ignored_index = 0;
        if (!number.empty() && !parse_integer(number, ignored_index)) break;
        rest.remove_prefix(1 + number.size());
    }
    if (!rest.empty()) reader.fail(fmt::format("the corner '{}' is not i, i/t, i//n or i/t/n", shown(word)));
    const auto count = static_cast<std::int64_t>(vertex_count);
    if (index == 0 || index > count || index < -count) {
        reader.fail(fmt::format("index {} is out of range: there are {} vertices so far", index, count));
    }
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

// "v x y z", with a weight, which must be 1, or with a colour behind it, which may be no finite one.
void read_vertex(const LineReader& reader, MeshSoup& soup) {
    soup.vertices.push_back(reader.point(1));
    const std::size_t count = reader.words().size();
    if (count == 5 && reader.number(4) != 1) reader.fail("a weight other than 1 is not supported");
    for (std::size_t i = 4; count > 5 && i < 7; ++i) reader.any_number(i);
    reader.require_end(7);
}

void read_face(const LineReader& reader, MeshSoup& soup) {
    if (reader.words().size() < 4) reader.fail("a face has fewer than three corners");
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 1; i < reader.words().size(); ++i) {
        corners.push_back(read_corner(reader, reader.words()[i], soup.vertices.size()));
    }
    soup.add_polygon(corners, [&] { return reader.place(); });
}

// The part that faces belong to, by the newest object and the newest group within it.
class CurrentPart {
  public:
    void begin_object(MeshSoup& soup, const std::string& name) {
        object_ = name;
        group_.clear();
        begin(soup);
    }
    void begin_group(MeshSoup& soup, const std::string& name) {
        group_ = name;
        begin(soup);
    }

  private:
    void begin(MeshSoup& soup) {
        const auto [entry, is_new] = parts_.try_emplace({object_, group_}, soup.part_names.size());
        if (is_new) {
            const bool has_one_name = object_.empty() || group_.empty() || object_ == group_;
            soup.part_names.push_back(has_one_name ? (object_.empty() ? group_ : object_) : object_ + "/" + group_);
        }
        soup.begin_run(entry->second);
    }

    std::string object_, group_;
    std::map<std::pair<std::string, std::string>, std::size_t> parts_;
};

}  // namespace

MeshSoup read_obj(const std::filesystem::path& file, std::string_view text) {
    MeshSoup soup;
    CurrentPart part;
    part.begin_object(soup, "");
    LineReader reader(file, text, {.comment = '#', .continuation = '\\'});
    while (reader.next_line()) {
        const std::string_view word = reader.words()[0];
        if (word == "v") {
            read_vertex(reader, soup);
        } else if (word == "f") {
            read_face(reader, soup);
        } else if (word == "o") {
            part.begin_object(soup, reader.name(1));
        } else if (word == "g") {
            part.begin_group(soup, reader.name(1));
        } else if (contains(unsupported, word)) {
            reader.fail(fmt::format("{} is not supported", word));
        } else if (!contains(ignored, word)) {
            reader.fail(fmt::format("'{}' does not begin a line of an OBJ file", shown(word)));
        }
    }
    return soup;
}

}  // namespace ecods::scenes
