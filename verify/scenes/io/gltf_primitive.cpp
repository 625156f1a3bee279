#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

// The elements of an accessor in the bytes of its buffer.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;

    template <class T>
    T value(std::size_t element, std::size_t component) const {
        T value;
        std::memcpy(&value, first + element * stride + component * sizeof(T), sizeof value);
        return value;
    }
};

// Checks that every element lies within its view, and the view within its buffer.
Elements elements_of(const GltfModel& model, const std::string& place, const tinygltf::Accessor& accessor) {
    const tinygltf::Model& m = model.model;
    if (accessor.sparse.isSparse) model.fail(place, "sparse accessors are not supported");
    if (!is_index_of(accessor.bufferView, m.bufferViews)) model.fail(place, "bufferView is missing or out of range");
    const tinygltf::BufferView& view = m.bufferViews[accessor.bufferView];
    if (!is_index_of(view.buffer, m.buffers)) model.fail(place, "the view's buffer is missing or out of range");
    const std::vector<unsigned char>& bytes = m.buffers[view.buffer].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
        model.fail(place, "the buffer view reaches beyond its buffer");
    }
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) *
                     tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const int stride = accessor.ByteStride(view);
    if (size <= 0 || stride < size) model.fail(place, "the type or the stride is invalid");
    const std::size_t room = accessor.byteOffset > view.byteLength ? 0 : view.byteLength - accessor.byteOffset;
    if (accessor.count > 0 &&
        (room < static_cast<std::size_t>(size) ||
         accessor.count - 1 > (room - static_cast<std::size_t>(size)) / static_cast<std::size_t>(stride))) {
        model.fail(place, "the accessor reaches beyond its buffer view");
    }
    return {bytes.data() + view.byteOffset + accessor.byteOffset, accessor.count, static_cast<std::size_t>(stride)};
}

const tinygltf::Accessor& accessor_at(const GltfModel& model, const std::string& place, int index) {
    if (!is_index_of(index, model.model.accessors)) model.fail(place, fmt::format("accessor {} does not exist", index));
    return model.model.accessors[index];
}

void add_positions(const GltfModel& model, const std::string& place, int index, MeshSoup& soup) {
    const tinygltf::Accessor& accessor = accessor_at(model, place, index);
    if (accessor.type != TINYGLTF_TYPE_VEC3 || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        model.fail(place, "positions are not three single-precision numbers");
    }
    const Elements elements = elements_of(model, place, accessor);
    for (std::size_t i = 0; i < elements.count; ++i) {
        const Vec3 point(static_cast<double>(elements.value<float>(i, 0)),
                         static_cast<double>(elements.value<float>(i, 1)),
                         static_cast<double>(elements.value<float>(i, 2)));
        if (!point.allFinite()) model.fail(place, fmt::format("vertex {}: a coordinate is not a finite number", i));
        soup.vertices.push_back(point);
    }
}

// The indices of a primitive, or 0, 1, 2, ... if it has none; each below vertex_count.
std::vector<std::uint32_t> read_indices(const GltfModel& model, const std::string& place, int index,
                                        std::size_t vertex_count) {
    std::vector<std::uint32_t> indices;
    if (index < 0) {
        for (std::size_t i = 0; i < vertex_count; ++i) indices.push_back(static_cast<std::uint32_t>(i));
        return indices;
    }
    const tinygltf::Accessor& accessor = accessor_at(model, place, index);
    const int type = accessor.componentType;
    const bool is_byte = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    const bool is_short = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool is_int = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (accessor.type != TINYGLTF_TYPE_SCALAR || !(is_byte || is_short || is_int)) {
        model.fail(place, "indices are not unsigned whole numbers");
    }
    const Elements elements = elements_of(model, place, accessor);
    for (std::size_t i = 0; i < elements.count; ++i) {
        const std::uint32_t value = is_byte    ? elements.value<std::uint8_t>(i, 0)
                                    : is_short ? elements.value<std::uint16_t>(i, 0)
                                               : elements.value<std::uint32_t>(i, 0);
        if (value >= vertex_count) {
            model.fail(place, fmt::format("index {} is out of range: there are {} vertices", value, vertex_count));
        }
        indices.push_back(value);
    }
    return indices;
}

void add_triangles(const GltfModel& model, const std::string& place, int mode, std::span<const std::uint32_t> corners,
                   MeshSoup& soup) {
    switch (mode) {
        case TINYGLTF_MODE_TRIANGLES:
            if (corners.size() % 3 != 0) model.fail(place, "the number of corners is no multiple of three");
            for (std::size_t i = 0; i < corners.size(); i += 3) soup.add_polygon(corners.subspan(i, 3));
            break;
        case TINYGLTF_MODE_TRIANGLE_STRIP:
            for (std::size_t i = 0; i + 3 <= corners.size(); ++i) soup.add_polygon(corners.subspan(i, 3));
            break;
        case TINYGLTF_MODE_TRIANGLE_FAN:
            soup.add_polygon(corners);
            break;
        default:
            model.fail(place + ".mode", fmt::format("mode {} (points or lines) is not supported", mode));
    }
}

}  // namespace

void add_primitive(const GltfModel& model, const std::string& place, const tinygltf::Primitive& primitive,
                   MeshSoup& soup) {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) model.fail(place, "there is no POSITION");
    const std::size_t first = soup.vertices.size();
    add_positions(model, place + ".attributes.POSITION", position->second, soup);
    if (soup.vertices.size() > std::numeric_limits<std::uint32_t>::max()) model.fail(place, "too many vertices");
    std::vector<std::uint32_t> corners =
        read_indices(model, place + ".indices", primitive.indices, soup.vertices.size() - first);
    for (std::uint32_t& corner : corners) corner += static_cast<std::uint32_t>(first);
    const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    add_triangles(model, place, mode, corners, soup);
}

}  // namespace ecods::scenes
