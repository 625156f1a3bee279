// Wavefront OBJ: the lines "v x y z ..." and "f i/t/n j/t/n k/t/n ...".
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {
namespace {

// A corner "i", "i/t", "i//n" or "i/t/n". Indices count from 1; negative ones count back from the newest vertex.
std::uint32_t read_corner(const LineReader& reader, std::string_view word, std::size_t vertex_count) {
    std::int64_t index = 0;
    if (!parse_integer(word.substr(0, word.find('/')), index)) reader.fail("a corner is not a whole number");
    const auto count = static_cast<std::int64_t>(vertex_count);
    if (index == 0 || index > count || index < -count) {
        reader.fail(fmt::format("index {} is out of range: there are {} vertices so far", index, count));
    }
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

bool is_keyword(std::string_view word) {
    return std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }) &&
           std::isalpha(static_cast<unsigned char>(word[0])) != 0;
}

}  // namespace

MeshSoup read_obj(const std::filesystem::path& file, std::string_view text) {
    MeshSoup soup;
    std::vector<std::uint32_t> corners;
    LineReader reader(file, text, {.comment = '#', .continuation = '\\'});
    while (reader.next_line()) {
        const auto& words = reader.words();
        if (words[0] == "v") {
            soup.vertices.push_back(reader.point(1));
        } else if (words[0] == "f") {
            if (words.size() < 4) reader.fail("a face has fewer than three corners");
            corners.clear();
            for (std::size_t i = 1; i < words.size(); ++i) {
                corners.push_back(read_corner(reader, words[i], soup.vertices.size()));
            }
            soup.add_polygon(corners);
        } else if (!is_keyword(words[0])) {
            reader.fail("this is not a line of an OBJ file");
        }
    }
    return soup;
}

}  // namespace ecods::scenes
