#include "scenes/io/gltf_model.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>

namespace ecods::scenes {
namespace {

// What changes the geometry of nodes or meshes, and would be missed without a word.
constexpr std::array<std::string_view, 4> unsupported_extensions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"};

// The JSON in a binary glTF is its first chunk.
std::string_view json_of(std::string_view bytes, bool is_binary) {
    if (!is_binary) return bytes;
    constexpr std::size_t header_size = 20;
    std::size_t length = 0;
    for (std::size_t i = 16; bytes.size() >= header_size && i-- > 12;) {
        length = length << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return bytes.substr(std::min(header_size, bytes.size()), length);
}

// tinygltf descends into nested values by recursion, so their depth must be limited before.
bool is_deep(std::string_view json) {
    constexpr int depth_max = 200;
    int depth = 0;
    bool is_in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') is_in_string = !is_in_string;
        if (is_in_string) {
            if (c == '\\') ++i;
            continue;
        }
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        if (depth > depth_max) return true;
    }
    return false;
}

// Textures are none of our business: they are neither decoded nor missed.
bool ignore_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace

GltfModel load_gltf(const std::filesystem::path& file) {
    const std::string bytes = read_bytes(file);
    const bool is_binary = bytes.starts_with("glTF");
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) throw ReadError(file, "", "larger than 4 GB");
    if (is_deep(json_of(bytes, is_binary))) throw ReadError(file, "", "the JSON is nested too deeply");

    GltfModel result;
    result.file = file;
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(ignore_image, nullptr);
    const std::string folder = file.parent_path().string();
    const auto size = static_cast<unsigned int>(bytes.size());
    std::string error;
    std::string warning;
    bool is_loaded = false;
    try {
        is_loaded =
            is_binary ? loader.LoadBinaryFromMemory(&result.model, &error, &warning,
                                                    reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                      : loader.LoadASCIIFromString(&result.model, &error, &warning, bytes.data(), size, folder);
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    // First, because it explains what tinygltf stumbles over.
    for (const std::string& extension : result.model.extensionsUsed) {
        if (std::find(unsupported_extensions.begin(), unsupported_extensions.end(), extension) !=
            unsupported_extensions.end()) {
            throw ReadError(file, "extensionsUsed", extension + " is not supported");
        }
    }
    if (!is_loaded)
        throw ReadError(file, "", error.empty() ? "not a glTF file" : "not a valid glTF file: " + first_line(error));
    return result;
}

}  // namespace ecods::scenes
