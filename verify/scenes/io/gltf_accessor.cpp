#include <fmt/format.h>

#include <algorithm>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

struct View {
    std::string_view bytes;
    std::size_t stride = 0;  // 0: elements follow each other
};

View read_view(const GltfModel& model, const JsonPlace& index) {
    const JsonPlace view = model.target(index, "bufferViews");
    const JsonPlace buffer = view.at("buffer");
    model.target(buffer, "buffers");
    const std::string& bytes = model.buffers[buffer.index()];
    const auto offset_place = view.find("byteOffset");
    const std::uint64_t offset = offset_place ? offset_place->count() : 0;
    const std::uint64_t length = view.at("byteLength").count();
    if (offset > bytes.size() || length > bytes.size() - offset) view.fail("the view reaches beyond its buffer");
    const auto stride = view.find("byteStride");
    return {std::string_view(bytes).substr(offset, length), stride ? stride->index() : 0};
}

std::size_t size_of(std::uint32_t component_type) {
    return component_type == gltf_ubyte ? 1 : component_type == gltf_ushort ? 2 : 4;
}

}  // namespace

GltfElements read_accessor(const GltfModel& model, const JsonPlace& index, std::string_view type,
                           std::span<const std::uint32_t> component_types) {
    const JsonPlace accessor = model.target(index, "accessors");
    if (accessor.find("sparse")) accessor.fail("sparse accessors are not supported");
    const std::uint32_t component_type = accessor.at("componentType").index();
    const bool is_known =
        std::find(component_types.begin(), component_types.end(), component_type) != component_types.end();
    if (accessor.at("type").text() != type || !is_known)
        index.fail(fmt::format("{} of componentType {} does not fit here", accessor.at("type").text(), component_type));
    const View view = read_view(model, accessor.at("bufferView"));
    const auto offset_place = accessor.find("byteOffset");
    const std::uint64_t offset = offset_place ? offset_place->count() : 0;
    const std::uint64_t count = accessor.at("count").count();
    const std::size_t size = size_of(component_type) * (type == "VEC3" ? 3 : 1);
    const std::size_t stride = view.stride == 0 ? size : view.stride;
    if (stride < size) accessor.fail("byteStride is less than the size of an element");
    const std::size_t room = offset > view.bytes.size() ? 0 : view.bytes.size() - offset;
    if (count > 0 && (room < size || count - 1 > (room - size) / stride))
        accessor.fail("the accessor reaches beyond its buffer view");
    return {count == 0 ? nullptr : view.bytes.data() + offset, count, stride, component_type};
}

}  // namespace ecods::scenes
