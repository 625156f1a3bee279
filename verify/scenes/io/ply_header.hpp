// The header of a PLY file: what the values in it mean.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/io/text_file.hpp"

namespace ecods::scenes {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type) noexcept;

// Whether the type has the number. All numbers are of a floating type but those beyond its largest.
bool has_value(PlyType type, double value) noexcept;

// The number that `bits` (as many as the type has) stand for.
double value_of(PlyType type, std::uint64_t bits) noexcept;

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType length_type = PlyType::uint8;
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t size = 0;        // bytes, the line end_header included
    std::size_t line_count = 0;  // the same in lines
};

// The index of the property that is a number, or a list, of one of the names; -1 if there is none.
std::ptrdiff_t find_property(const PlyElement& element, std::initializer_list<std::string_view> names, bool is_list);

// Throws ReadError with the line. Checked: a vertex has numbers x, y and z; a face has a list of indices; no name is
// given twice; no element but faces makes a surface; nothing stands behind what a line should have. A line that begins
// with "Created by" is a comment: Blender 2.4 forgot to say so.
PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view text);

}  // namespace ecods::scenes
