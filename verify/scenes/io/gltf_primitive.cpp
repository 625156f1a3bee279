#include <fmt/format.h>

#include <array>
#include <cstring>
#include <limits>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

template <class T>
T component(const GltfElements& elements, std::size_t element, std::size_t index) {
    T value;
    std::memcpy(&value, elements.first + element * elements.stride + index * sizeof(T), sizeof value);
    return value;
}

void add_positions(const GltfModel& model, const JsonPlace& index, MeshSoup& soup) {
    const GltfElements elements = read_accessor(model, index, "VEC3", std::array{gltf_float});
    for (std::size_t i = 0; i < elements.count; ++i) {
        const Vec3 point(static_cast<double>(component<float>(elements, i, 0)),
                         static_cast<double>(component<float>(elements, i, 1)),
                         static_cast<double>(component<float>(elements, i, 2)));
        if (!point.allFinite()) index.fail(fmt::format("vertex {}: a coordinate is not a finite number", i));
        soup.vertices.push_back(point);
    }
}

std::uint32_t index_at(const GltfElements& elements, std::size_t i) {
    if (elements.component_type == gltf_ubyte) return component<std::uint8_t>(elements, i, 0);
    if (elements.component_type == gltf_ushort) return component<std::uint16_t>(elements, i, 0);
    return component<std::uint32_t>(elements, i, 0);
}

// The indices of a primitive, or 0, 1, 2, ... if it has none; each below vertex_count.
std::vector<std::uint32_t> read_indices(const GltfModel& model, const JsonPlace& primitive, std::size_t vertex_count) {
    std::vector<std::uint32_t> indices;
    const auto index = primitive.find("indices");
    if (!index) {
        for (std::size_t i = 0; i < vertex_count; ++i) indices.push_back(static_cast<std::uint32_t>(i));
        return indices;
    }
    const GltfElements elements =
        read_accessor(model, *index, "SCALAR", std::array{gltf_ubyte, gltf_ushort, gltf_uint});
    for (std::size_t i = 0; i < elements.count; ++i) {
        indices.push_back(index_at(elements, i));
        if (indices.back() >= vertex_count) {
            index->fail(fmt::format("index {} is out of range: there are {} vertices", indices.back(), vertex_count));
        }
    }
    return indices;
}

void add_triangles(const JsonPlace& primitive, std::span<const std::uint32_t> corners, MeshSoup& soup) {
    constexpr std::uint32_t triangles = 4;
    constexpr std::uint32_t strip = 5;
    constexpr std::uint32_t fan = 6;
    const auto place = primitive.find("mode");
    const std::uint32_t mode = place ? place->index() : triangles;
    if (mode == triangles) {
        if (corners.size() % 3 != 0) primitive.fail("the number of corners is no multiple of three");
        for (std::size_t i = 0; i < corners.size(); i += 3) soup.add_fan(corners.subspan(i, 3));
    } else if (mode == strip) {
        for (std::size_t i = 0; i + 3 <= corners.size(); ++i) soup.add_fan(corners.subspan(i, 3));
    } else if (mode == fan) {
        soup.add_fan(corners);
    } else {
        place->fail(fmt::format("mode {} (points or lines) is not supported", mode));
    }
}

}  // namespace

void add_primitive(const GltfModel& model, const JsonPlace& primitive, MeshSoup& soup) {
    const std::size_t first = soup.vertices.size();
    add_positions(model, primitive.at("attributes").at("POSITION"), soup);
    if (soup.vertices.size() > std::numeric_limits<std::uint32_t>::max()) primitive.fail("too many vertices");
    std::vector<std::uint32_t> corners = read_indices(model, primitive, soup.vertices.size() - first);
    for (std::uint32_t& corner : corners) corner += static_cast<std::uint32_t>(first);
    add_triangles(primitive, corners, soup);
}

}  // namespace ecods::scenes
