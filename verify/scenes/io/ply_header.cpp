#include "scenes/io/ply_header.hpp"

#include <array>
#include <bit>
#include <utility>

namespace ecods::scenes {
namespace {

struct TypeName {
    std::string_view old_name;
    std::string_view new_name;
    std::size_t size;
};

// By PlyType.
constexpr std::array<TypeName, 8> types{{{"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4},
                                         {"float", "float32", 4},
                                         {"double", "float64", 8}}};

PlyType type_named(const LineReader& reader, std::size_t index) {
    if (index >= reader.words().size()) reader.fail("the property is incomplete");
    const std::string_view word = reader.words()[index];
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (word == types[i].old_name || word == types[i].new_name) return static_cast<PlyType>(i);
    }
    reader.fail("unknown type of property");
}

PlyFormat format_named(const LineReader& reader) {
    if (reader.words().size() < 2 || reader.words()[0] != "format") reader.fail("the format should be here");
    const std::string_view word = reader.words()[1];
    if (word == "ascii") return PlyFormat::text;
    if (word == "binary_little_endian") return PlyFormat::little_endian;
    if (word == "binary_big_endian") return PlyFormat::big_endian;
    reader.fail("unknown format");
}

PlyElement read_element(const LineReader& reader) {
    if (reader.words().size() < 3) reader.fail("the element is incomplete");
    const std::int64_t count = reader.integer(2);
    if (count < 0) reader.fail("a count is negative");
    return {std::string(reader.words()[1]), count, {}};
}

PlyProperty read_property(const LineReader& reader) {
    PlyProperty property;
    property.is_list = reader.words().size() > 1 && reader.words()[1] == "list";
    const std::size_t type = property.is_list ? 3 : 1;
    property.type = type_named(reader, type);
    if (property.is_list) property.length_type = type_named(reader, 2);
    if (reader.words().size() <= type + 1) reader.fail("the property is incomplete");
    property.name = reader.words()[type + 1];
    return property;
}

void check_elements(const LineReader& reader, const PlyHeader& header) {
    bool has_vertex = false;
    bool has_face = false;
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex") {
            has_vertex = true;
            for (const std::string_view axis : {"x", "y", "z"}) {
                if (find_property(element, {axis}, false) < 0) reader.fail("a vertex has no x, y or z");
            }
        } else if (element.name == "face") {
            if (!has_vertex) reader.fail("faces come before vertices");
            has_face = true;
            if (find_property(element, {"vertex_indices", "vertex_index"}, true) < 0)
                reader.fail("a face has no vertex_indices");
        }
    }
    if (!has_vertex || !has_face) reader.fail("the file has no vertices, or no faces");
}

}  // namespace

std::size_t size_of(PlyType type) noexcept {
    return types[static_cast<std::size_t>(type)].size;
}

double value_of(PlyType type, std::uint64_t bits) noexcept {
    switch (type) {
        case PlyType::int8:
            return static_cast<std::int8_t>(bits);
        case PlyType::uint8:
            return static_cast<std::uint8_t>(bits);
        case PlyType::int16:
            return static_cast<std::int16_t>(bits);
        case PlyType::uint16:
            return static_cast<std::uint16_t>(bits);
        case PlyType::int32:
            return static_cast<std::int32_t>(bits);
        case PlyType::uint32:
            return static_cast<std::uint32_t>(bits);
        case PlyType::float32:
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        case PlyType::float64:
            return std::bit_cast<double>(bits);
    }
    return 0;
}

std::ptrdiff_t find_property(const PlyElement& element, std::initializer_list<std::string_view> names, bool is_list) {
    for (const std::string_view name : names) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (property.name == name && property.is_list == is_list) return static_cast<std::ptrdiff_t>(i);
        }
    }
    return -1;
}

PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view text) {
    LineReader reader(file, text, {});
    PlyHeader header;
    reader.require_line("ply");
    if (reader.words()[0] != "ply") reader.fail("the file does not begin with ply");
    reader.require_line("the format");
    header.format = format_named(reader);
    while (true) {
        reader.require_line("end_header");
        const std::string_view word = reader.words()[0];
        if (word == "end_header") break;
        if (word == "element") {
            header.elements.push_back(read_element(reader));
        } else if (word == "property") {
            if (header.elements.empty()) reader.fail("a property belongs to no element");
            header.elements.back().properties.push_back(read_property(reader));
        } else if (word != "comment" && word != "obj_info") {
            reader.fail("this is not a line of a PLY header");
        }
    }
    check_elements(reader, header);
    header.size = reader.position();
    return header;
}

}  // namespace ecods::scenes
