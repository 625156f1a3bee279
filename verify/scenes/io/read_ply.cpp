// PLY, text and binary of either byte order.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scenes/io/mesh_soup.hpp"
#include "scenes/io/parse_number.hpp"
#include "scenes/io/ply_header.hpp"

namespace ecods::scenes {
namespace {

// Reads values one by one. In text every item has a line of its own.
class PlyValues {
  public:
    PlyValues(const std::filesystem::path& file, std::string_view text, const PlyHeader& header)
        : file_(file),
          text_(text.substr(header.size)),
          format_(header.format),
          reader_(file, text_, {}, header.line_count) {}

    void begin_item(const std::string& element, std::int64_t index) {
        element_ = &element;
        index_ = index;
        word_ = 0;
        if (format_ == PlyFormat::text && !reader_.next_line()) fail("the file ends here");
    }

    double next(PlyType type) { return format_ == PlyFormat::text ? next_word(type) : next_bytes(type); }

    void end_item() const {
        if (word_ < reader_.words().size()) fail("the line has more values than properties");
    }

    void end_file() {
        if (format_ == PlyFormat::text && reader_.next_line()) reader_.fail("the file goes on behind the last element");
        if (format_ != PlyFormat::text && position_ < text_.size())
            throw ReadError(file_, "", fmt::format("{} bytes follow the last element", text_.size() - position_));
    }

    // Whether `count` more values can be in the file at all.
    bool has_room(double count) const { return count <= static_cast<double>(text_.size()); }

    std::string place() const {
        const std::string item = fmt::format("{} {}", *element_, index_);
        return format_ == PlyFormat::text ? fmt::format("{}, {}", reader_.place(), item) : item;
    }

    [[noreturn]] void fail(const std::string& text) const { throw ReadError(file_, place(), text); }

  private:
    double next_word(PlyType type) {
        if (word_ == reader_.words().size()) fail("the line has fewer values than properties");
        const std::string_view word = reader_.words()[word_++];
        double value = 0;
        if (!parse_number(word, value)) fail(fmt::format("'{}' is not a number", shown(word)));
        if (!has_value(type, value)) fail(fmt::format("{} is not a value of the property's type", shown(word)));
        return value;
    }

    double next_bytes(PlyType type) {
        const std::size_t size = size_of(type);
        if (text_.size() - position_ < size) fail("the file ends here");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t offset = format_ == PlyFormat::big_endian ? i : size - 1 - i;
            bits = bits << 8 | static_cast<unsigned char>(text_[position_ + offset]);
        }
        position_ += size;
        return value_of(type, bits);
    }

    std::filesystem::path file_;
    std::string_view text_;
    PlyFormat format_;
    LineReader reader_;
    std::size_t word_ = 0;      // next in the reader's line
    std::size_t position_ = 0;  // next in the bytes
    const std::string* element_ = nullptr;
    std::int64_t index_ = 0;
};

std::int64_t whole(const PlyValues& values, double x) {
    // All integer types of the format are exact in a double.
    if (x != std::floor(x) || std::abs(x) > 4294967296.0) values.fail(fmt::format("{} is not an index", x));
    return static_cast<std::int64_t>(x);
}

// One item: single numbers and lists, by property.
struct PlyItem {
    std::vector<double> numbers;
    std::vector<std::vector<double>> lists;
};

void read_item(PlyValues& values, const PlyElement& element, PlyItem& item) {
    item.numbers.assign(element.properties.size(), 0);
    item.lists.resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (!property.is_list) {
            item.numbers[p] = values.next(property.type);
            continue;
        }
        const double length = values.next(property.length_type);
        if (length < 0 || !values.has_room(length)) values.fail("a list has an impossible length");
        item.lists[p].clear();
        for (std::int64_t i = whole(values, length); i > 0; --i) item.lists[p].push_back(values.next(property.type));
    }
}

void add_vertex(MeshSoup& soup, const PlyValues& values, const Vec3& vertex) {
    if (!vertex.allFinite()) values.fail("a coordinate is not a finite number");
    soup.vertices.push_back(vertex);
}

void add_face(MeshSoup& soup, const PlyValues& values, const std::vector<double>& list) {
    if (list.size() < 3) values.fail("a face has fewer than three corners");
    std::vector<std::uint32_t> corners;
    for (const double x : list) {
        const std::int64_t index = whole(values, x);
        if (index < 0 || index >= static_cast<std::int64_t>(soup.vertices.size())) {
            values.fail(fmt::format("index {} is out of range: there are {} vertices", index, soup.vertices.size()));
        }
        corners.push_back(static_cast<std::uint32_t>(index));
    }
    soup.add_polygon(corners, [&] { return values.place(); });
}

}  // namespace

MeshSoup read_ply(const std::filesystem::path& file, std::string_view text) {
    const PlyHeader header = read_ply_header(file, text);
    PlyValues values(file, text, header);
    MeshSoup soup;
    PlyItem item;
    for (const PlyElement& element : header.elements) {
        const bool is_vertex = element.name == "vertex";
        const bool is_face = element.name == "face";
        const std::ptrdiff_t x = find_property(element, {"x"}, false);
        const std::ptrdiff_t y = find_property(element, {"y"}, false);
        const std::ptrdiff_t z = find_property(element, {"z"}, false);
        const std::ptrdiff_t corners = find_property(element, {"vertex_indices", "vertex_index"}, true);
        // Without properties an item has no bytes, and its count could be anything.
        if (element.properties.empty()) continue;
        for (std::int64_t i = 0; i < element.count; ++i) {
            values.begin_item(element.name, i);
            read_item(values, element, item);
            values.end_item();
            if (is_vertex) add_vertex(soup, values, {item.numbers[x], item.numbers[y], item.numbers[z]});
            if (is_face) add_face(soup, values, item.lists[corners]);
        }
    }
    values.end_file();
    return soup;
}

}  // namespace ecods::scenes
