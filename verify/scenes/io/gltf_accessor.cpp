#include "scenes/io/gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace ecods::scenes {
namespace {

struct View {
    std::string_view bytes;
    std::size_t stride = 0;  // 0: elements follow each other
};

std::uint64_t offset_of(const JsonPlace& place) {
    const auto offset = place.find("byteOffset");
    return offset ? offset->count() : 0;
}

View read_view(const GltfModel& model, const JsonPlace& index) {
    const JsonPlace view = model.target(index, "bufferViews");
    const JsonPlace buffer = view.at("buffer");
    model.target(buffer, "buffers");
    const std::string& bytes = *model.buffers[buffer.index()];
    const std::uint64_t offset = offset_of(view);
    const std::uint64_t length = view.at("byteLength").count();
    if (offset > bytes.size() || length > bytes.size() - offset) view.fail("the view reaches beyond its buffer");
    const auto stride = view.find("byteStride");
    return {std::string_view(bytes).substr(offset, length), stride ? stride->index() : 0};
}

// Elements in a buffer view, which `place` names: an accessor or a part of one.
struct Block {
    const char* first = nullptr;
    std::size_t stride = 0;
};

Block read_block(const GltfModel& model, const JsonPlace& place, std::uint64_t count, std::size_t size) {
    const View view = read_view(model, place.at("bufferView"));
    const std::uint64_t offset = offset_of(place);
    const std::size_t stride = view.stride == 0 ? size : view.stride;
    if (stride < size) place.fail("byteStride is less than the size of an element");
    const std::size_t room = offset > view.bytes.size() ? 0 : view.bytes.size() - offset;
    if (count > 0 && (room < size || count - 1 > (room - size) / stride))
        place.fail("the accessor reaches beyond its buffer view");
    return {count == 0 ? nullptr : view.bytes.data() + offset, stride};
}

std::size_t size_of(GltfType type) {
    if (type == GltfType::byte || type == GltfType::ubyte) return 1;
    return type == GltfType::short_ || type == GltfType::ushort ? 2 : 4;
}

std::size_t component_count(std::string_view shape) {
    return shape == "SCALAR" ? 1 : shape == "VEC3" ? 3 : shape == "VEC4" ? 4 : 16;
}

// The type, if it is among the given ones.
std::optional<GltfType> read_type(const JsonPlace& accessor, std::span<const GltfType> types) {
    const auto found = std::find(types.begin(), types.end(), GltfType{accessor.at("componentType").index()});
    return found == types.end() ? std::nullopt : std::optional(*found);
}

template <class T>
T value_at(const char* bytes, std::size_t component) {
    T value;
    std::memcpy(&value, bytes + component * sizeof(T), sizeof value);
    return value;
}

// A sparse accessor may have no more of them than elements.
void read_replaced(GltfModel& model, const JsonPlace& sparse, GltfElements& elements) {
    constexpr std::array types{GltfType::ubyte, GltfType::ushort, GltfType::uint};
    const std::uint64_t count = sparse.at("count").count();
    const JsonPlace indices = sparse.at("indices");
    const auto type = read_type(indices, types);
    if (!type) indices.fail("componentType is none of an index");
    const auto read_tight_block = [&](const JsonPlace& place, std::size_t size) {
        const Block block = read_block(model, place, count, size);
        if (block.stride != size) place.fail("a byteStride does not fit here");
        return block.first;
    };
    GltfElements list{.count = count, .type = *type, .size = size_of(*type), .stride = size_of(*type)};
    list.first = read_tight_block(indices, list.size);
    elements.replacements = read_tight_block(sparse.at("values"), elements.size);
    model.spend(sparse, count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = list.whole(i);
        if (index >= elements.count || (i > 0 && index <= elements.replaced.back()))
            indices.fail(fmt::format("index {} is not above the one before and below {}", index, elements.count));
        elements.replaced.push_back(index);
    }
}

double normalized(double value, double value_max) {
    return std::max(value / value_max, -1.0);
}

}  // namespace

const char* GltfElements::bytes(std::size_t element) const {
    static constexpr std::array<char, 64> zeros{};
    if (!replaced.empty()) {
        const auto found = std::lower_bound(replaced.begin(), replaced.end(), element);
        if (found != replaced.end() && *found == element)
            return replacements + static_cast<std::size_t>(found - replaced.begin()) * size;
    }
    return first == nullptr ? zeros.data() : first + element * stride;
}

double GltfElements::number(std::size_t element, std::size_t component) const {
    const char* from = bytes(element);
    const auto whole_number = [&]<class T>(T value) {
        const double number = static_cast<double>(value);
        return is_normalized ? normalized(number, static_cast<double>(std::numeric_limits<T>::max())) : number;
    };
    switch (type) {
        case GltfType::byte:
            return whole_number(value_at<std::int8_t>(from, component));
        case GltfType::ubyte:
            return whole_number(value_at<std::uint8_t>(from, component));
        case GltfType::short_:
            return whole_number(value_at<std::int16_t>(from, component));
        case GltfType::ushort:
            return whole_number(value_at<std::uint16_t>(from, component));
        case GltfType::uint:
            return static_cast<double>(value_at<std::uint32_t>(from, component));
        case GltfType::float_:
            break;
    }
    return static_cast<double>(value_at<float>(from, component));
}

std::uint32_t GltfElements::whole(std::size_t element, std::size_t component) const {
    const char* from = bytes(element);
    if (type == GltfType::ubyte) return value_at<std::uint8_t>(from, component);
    if (type == GltfType::ushort) return value_at<std::uint16_t>(from, component);
    return value_at<std::uint32_t>(from, component);
}

GltfElements read_accessor(GltfModel& model, const JsonPlace& index, std::string_view shape,
                           std::span<const GltfType> types) {
    const JsonPlace accessor = model.target(index, "accessors");
    const auto type = read_type(accessor, types);
    if (accessor.at("type").text() != shape || !type) {
        index.fail(fmt::format("{} of componentType {} does not fit here", accessor.at("type").text(),
                               accessor.at("componentType").index()));
    }
    GltfElements elements{.count = accessor.at("count").count(), .type = *type};
    elements.size = size_of(*type) * component_count(shape);
    const auto is_normalized = accessor.find("normalized");
    elements.is_normalized = is_normalized && is_normalized->boolean();
    if (accessor.find("bufferView")) {
        const Block block = read_block(model, accessor, elements.count, elements.size);
        elements.first = block.first;
        elements.stride = block.stride;
    }
    if (const auto sparse = accessor.find("sparse")) read_replaced(model, *sparse, elements);
    return elements;
}

}  // namespace ecods::scenes
