// Numbers in the buffers of glTF; for gltf_*.cpp only.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {

// The types of an element's components, by their numbers in the file.
enum class GltfType : std::uint32_t {
    byte = 5120,
    ubyte = 5121,
    short_ = 5122,
    ushort = 5123,
    uint = 5125,
    float_ = 5126
};

// The elements of an accessor; every one lies in the bytes of its buffer, or is zero.
struct GltfElements {
    std::size_t count = 0;
    GltfType type = GltfType::float_;
    bool is_normalized = false;
    std::size_t size = 0;         // of an element, in bytes
    const char* first = nullptr;  // null: all are zero, but for those replaced
    std::size_t stride = 0;
    std::vector<std::uint32_t> replaced = {};  // elements of a sparse accessor that have other values, ascending
    const char* replacements = nullptr;        // their bytes, one behind the other

    // Floats and whole numbers as they are. Normalised ones become the double nearest to c / c_max, where c_max is the
    // largest number of the type, and at least -1: 32767 of a short is exactly 1.
    double number(std::size_t element, std::size_t component) const;

    // A component of an unsigned type.
    std::uint32_t whole(std::size_t element, std::size_t component = 0) const;

  private:
    const char* bytes(std::size_t element) const;
};

// Throws ReadError if the accessor has another shape ("SCALAR", "VEC3", "VEC4" or "MAT4"), or a component type that is
// not among the given ones. Sparse accessors and those without a buffer view are read, too.
GltfElements read_accessor(GltfModel& model, const JsonPlace& index, std::string_view shape,
                           std::span<const GltfType> types);

}  // namespace ecods::scenes
