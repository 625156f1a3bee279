#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "scenes/io/gltf_model.hpp"
#include "scenes/io/json_file.hpp"
#include "scenes/io/read_bytes.hpp"

namespace ecods::scenes {
namespace {

constexpr std::string_view quantization = "KHR_mesh_quantization";

// They change the geometry of nodes or meshes.
constexpr std::array<std::string_view, 4> unsupported_extensions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};

// Extensions that begin so are about how things look.
constexpr std::array<std::string_view, 9> looks{"KHR_materials_", "KHR_texture_",    "KHR_lights_",
                                                "KHR_technique",  "EXT_texture_",    "EXT_materials_",
                                                "EXT_lights_",    "ADOBE_materials", "MSFT_texture_"};

// Each accessor of a file has a byte at least for each of its elements. So a file whose accessors are all read eight
// times, as they may be where meshes share them, is read, and so is a small one of any kind.
constexpr std::uint64_t readings_max = 8;
constexpr std::uint64_t elements_always_read = 1 << 20;

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

// The standard demands that a file is refused if an extension that it requires is not known.
void check_extension(const JsonPlace& list, const std::string& name, bool is_required) {
    const auto* found = std::find(unsupported_extensions.begin(), unsupported_extensions.end(), name);
    const bool is_known = name == quantization || std::any_of(looks.begin(), looks.end(), [&](std::string_view begin) {
                              return name.starts_with(begin);
                          });
    if (found != unsupported_extensions.end() || (is_required && !is_known)) list.fail(name + " is not supported");
}

void read_extensions(GltfModel& model) {
    for (const std::string list : {"extensionsUsed", "extensionsRequired"}) {
        const auto extensions = model.root().find(list);
        if (!extensions) continue;
        for (const JsonPlace& extension : extensions->elements()) {
            check_extension(*extensions, extension.text(), list == "extensionsRequired");
            if (extension.text() == quantization) model.is_quantized = true;
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

void GltfModel::spend(const JsonPlace& place, std::uint64_t count) {
    if (count > elements_max - elements_read) {
        place.fail(fmt::format(
            "with this, more than {} elements of accessors would be read: they are named over and over", elements_max));
    }
    elements_read += count;
}

GltfModel load_gltf(const std::filesystem::path& file, NamedFiles allowed) {
    const std::string bytes = read_bytes(file);
    Container container{bytes, {}};
    if (bytes.starts_with("glTF")) container = open_binary(file, bytes);
    GltfModel model{file, parse_json(file, container.json), {}};
    check_version(model.root());
    read_extensions(model);
    GltfBuffers reader(allowed);
    if (const auto buffers = model.root().find("buffers")) {
        for (std::size_t i = 0; i < buffers->size(); ++i) {
            const std::string_view embedded = i == 0 ? container.embedded : std::string_view();
            model.buffers.push_back(reader.read(buffers->element(i), embedded));
        }
    }
    model.elements_max = elements_always_read + readings_max * (bytes.size() + reader.file_bytes());
    return model;
}

}  // namespace ecods::scenes
