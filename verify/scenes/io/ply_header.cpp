#include "scenes/io/ply_header.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
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
    if (reader.words().size() < 3 || reader.words()[2] != "1.0") reader.fail("the version of the format is not 1.0");
    reader.require_end(3);
    const std::string_view word = reader.words()[1];
    if (word == "ascii") return PlyFormat::text;
    if (word == "binary_little_endian") return PlyFormat::little_endian;
    if (word == "binary_big_endian") return PlyFormat::big_endian;
    reader.fail("unknown format");
}

void add_element(const LineReader& reader, PlyHeader& header) {
    if (reader.words().size() < 3) reader.fail("the element is incomplete");
    reader.require_end(3);
    const std::int64_t count = reader.integer(2);
    if (count < 0) reader.fail("a count is negative");
    const std::string name(reader.words()[1]);
    if (name == "tristrips") reader.fail("tristrips are not supported");
    for (const PlyElement& element : header.elements) {
        if (element.name == name) reader.fail("the element " + shown(name) + " is given twice");
    }
    header.elements.push_back({name, count, {}});
}

void add_property(const LineReader& reader, PlyHeader& header) {
    if (header.elements.empty()) reader.fail("a property belongs to no element");
    PlyProperty property;
    property.is_list = reader.words().size() > 1 && reader.words()[1] == "list";
    const std::size_t type = property.is_list ? 3 : 1;
    property.type = type_named(reader, type);
    if (property.is_list) property.length_type = type_named(reader, 2);
    if (reader.words().size() <= type + 1) reader.fail("the property is incomplete");
    reader.require_end(type + 2);
    property.name = reader.words()[type + 1];
    auto& properties = header.elements.back().properties;
    for (const PlyProperty& other : properties) {
        if (other.name == property.name) reader.fail("the property " + shown(property.name) + " is given twice");
    }
    properties.push_back(std::move(property));
}

void check_vertex(const LineReader& reader, const PlyElement& vertex) {
    for (const std::string_view axis : {"x", "y", "z"}) {
        if (find_property(vertex, {axis}, false) < 0) reader.fail("a vertex has no x, y or z");
    }
}

void check_face(const LineReader& reader, const PlyElement& face) {
    const bool has_indices = find_property(face, {"vertex_indices"}, true) >= 0;
    const bool has_index = find_property(face, {"vertex_index"}, true) >= 0;
    if (!has_indices && !has_index) reader.fail("a face has no vertex_indices");
    if (has_indices && has_index) reader.fail("a face has both vertex_indices and vertex_index");
}

void check_elements(const LineReader& reader, const PlyHeader& header) {
    bool has_vertex = false;
    bool has_face = false;
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex") {
            has_vertex = true;
            check_vertex(reader, element);
        } else if (element.name == "face") {
            if (!has_vertex) reader.fail("faces come before vertices");
            has_face = true;
            check_face(reader, element);
        }
    }
    if (!has_vertex || !has_face) reader.fail("the file has no vertices, or no faces");
}

bool is_comment(const LineReader& reader) {
    const auto& words = reader.words();
    return words[0] == "comment" || words[0] == "obj_info" ||
           (words.size() > 1 && words[0] == "Created" && words[1] == "by");
}

}  // namespace

std::size_t size_of(PlyType type) noexcept {
    return types[static_cast<std::size_t>(type)].size;
}

bool has_value(PlyType type, double value) noexcept {
    const auto is_whole_in = [&](double min, double max) {
        return value >= min && value <= max && value == std::floor(value);
    };
    switch (type) {
        case PlyType::int8:
            return is_whole_in(-0x1p7, 0x1p7 - 1);
        case PlyType::uint8:
            return is_whole_in(0, 0x1p8 - 1);
        case PlyType::int16:
            return is_whole_in(-0x1p15, 0x1p15 - 1);
        case PlyType::uint16:
            return is_whole_in(0, 0x1p16 - 1);
        case PlyType::int32:
            return is_whole_in(-0x1p31, 0x1p31 - 1);
        case PlyType::uint32:
            return is_whole_in(0, 0x1p32 - 1);
        case PlyType::float32:
            return !std::isfinite(value) || std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
        case PlyType::float64:
            return true;
    }
    return false;
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
    reader.require_end(1);
    reader.require_line("the format");
    header.format = format_named(reader);
    while (true) {
        reader.require_line("end_header");
        const std::string_view word = reader.words()[0];
        if (word == "end_header") break;
        if (word == "element") {
            add_element(reader, header);
        } else if (word == "property") {
            add_property(reader, header);
        } else if (!is_comment(reader)) {
            reader.fail("this is not a line of a PLY header");
        }
    }
    reader.require_end(1);
    check_elements(reader, header);
    header.size = reader.position();
    header.line_count = reader.line();
    return header;
}

}  // namespace ecods::scenes
