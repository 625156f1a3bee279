#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "scenes/io/gltf_model.hpp"
#include "scenes/io/json_file.hpp"
#include "scenes/io/read_bytes.hpp"

namespace ecods::scenes {
namespace {

// They change the geometry of nodes or meshes.
constexpr std::array<std::string_view, 4> unsupported_extensions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"};

constexpr std::size_t header_size = 12;  // of a binary file: magic, version, length; little-endian words of 32 bits
constexpr std::size_t chunk_header_size = 8;  // length, type
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t buffer_chunk = 0x004E4942;

std::uint32_t word_at(std::string_view bytes, std::size_t position) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[position + i]);
    return word;
}

struct Container {
    std::string_view json;
    std::string_view embedded;  // buffer
};

std::string unsupported(const std::string& version) {
    return "glTF " + version + " is not supported, only glTF 2 is";
}

// JSON comes first, then perhaps a buffer; chunks of other types are to be skipped, says the standard.
Container open_binary(const std::filesystem::path& file, std::string_view bytes) {
    const auto fail = [&](const std::string& text) { throw ReadError(file, "", text); };
    if (bytes.size() < header_size) fail("the file ends within its header");
    const std::uint32_t version = word_at(bytes, 4);
    if (version != 2) fail(unsupported(fmt::format("{} (binary)", version)));
    if (word_at(bytes, 8) != bytes.size())
        fail(fmt::format("the header promises {} bytes, and there are {}", word_at(bytes, 8), bytes.size()));
    Container container;
    std::size_t chunk_count = 0;
    for (std::size_t at = header_size; at < bytes.size(); ++chunk_count) {
        if (bytes.size() - at < chunk_header_size) fail("the file ends within the header of a chunk");
        const std::uint32_t length = word_at(bytes, at);
        const std::uint32_t type = word_at(bytes, at + 4);
        at += chunk_header_size;
        if (bytes.size() - at < length) fail("the file ends within a chunk");
        if ((type == json_chunk) != (chunk_count == 0)) fail("JSON is not the first chunk, or not the only one of it");
        if (type == json_chunk) container.json = bytes.substr(at, length);
        if (type == buffer_chunk && chunk_count == 1) container.embedded = bytes.substr(at, length);
        at += length;
    }
    if (chunk_count == 0) fail("there is no chunk of JSON");
    return container;
}

void check_version(const JsonPlace& root) {
    const auto asset = root.find("asset");
    const auto version = asset ? asset->find("version") : std::nullopt;
    if (!version) root.fail("there is no asset.version: not glTF 2, perhaps glTF 1.0, which is not supported");
    const std::string text = version->value().is_number() ? version->value().dump() : version->text();
    if (text.substr(0, text.find('.')) != "2") version->fail(unsupported(text));
}

void check_extensions(const JsonPlace& root) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        const auto extensions = root.find(list);
        if (!extensions) continue;
        for (const JsonPlace& extension : extensions->elements()) {
            const auto* found =
                std::find(unsupported_extensions.begin(), unsupported_extensions.end(), extension.text());
            if (found != unsupported_extensions.end()) extensions->fail(extension.text() + " is not supported");
        }
    }
}

}  // namespace

JsonPlace GltfModel::target(const JsonPlace& index, const char* list) const {
    const auto elements = root().find(list);
    const std::uint32_t i = index.index();
    if (!elements || i >= elements->size()) index.fail(fmt::format("{}[{}] does not exist", list, i));
    return elements->element(i);
}

GltfModel load_gltf(const std::filesystem::path& file) {
    const std::string bytes = read_bytes(file);
    Container container{bytes, {}};
    if (bytes.starts_with("glTF")) container = open_binary(file, bytes);
    GltfModel model{file, parse_json(file, container.json), {}};
    check_version(model.root());
    check_extensions(model.root());
    if (const auto buffers = model.root().find("buffers")) {
        for (std::size_t i = 0; i < buffers->size(); ++i) {
            const std::string_view embedded = i == 0 ? container.embedded : std::string_view();
            model.buffers.push_back(read_gltf_buffer(file, buffers->element(i), embedded));
        }
    }
    return model;
}

}  // namespace ecods::scenes
