// The parts of reading glTF; for gltf_*.cpp only.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ecods/pose.hpp"
#include "scenes/io/json_place.hpp"
#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {

struct GltfModel {
    std::filesystem::path file;
    nlohmann::json document;
    std::vector<std::string> buffers;  // bytes

    // Refers to the model, as all that is reached from it does.
    JsonPlace root() const { return {file, document}; }

    // The element of one of the lists at the root that `index` names. Throws ReadError at `index` if there is none.
    JsonPlace target(const JsonPlace& index, const char* list) const;
};

// Reads the file and its buffers. Checked: the version, the containers and extensions; not what the JSON describes.
GltfModel load_gltf(const std::filesystem::path& file);

// The bytes of a buffer: from its URI, or, where it has none, the bytes that come in the file itself ("" if none do).
std::string read_gltf_buffer(const std::filesystem::path& file, const JsonPlace& buffer, std::string_view embedded);

// The pose of a node relative to its parent, from its matrix or its translation, rotation and scale.
Pose local_pose(const JsonPlace& node);

// The poses of the nodes of the scene, by node, accumulated in double precision; nothing for nodes outside it. Throws
// ReadError unless the hierarchy is a forest: a body would be two, or none.
std::vector<std::optional<Pose>> world_poses(const GltfModel& model);

// The elements of an accessor in the bytes of its buffer; every one lies there.
struct GltfElements {
    const char* first = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::uint32_t component_type = 0;
};

constexpr std::uint32_t gltf_ubyte = 5121;
constexpr std::uint32_t gltf_ushort = 5123;
constexpr std::uint32_t gltf_uint = 5125;
constexpr std::uint32_t gltf_float = 5126;

// Throws ReadError if the accessor has another type ("SCALAR" or "VEC3"), or a component type that is not among those.
GltfElements read_accessor(const GltfModel& model, const JsonPlace& index, std::string_view type,
                           std::span<const std::uint32_t> component_types);

// Adds the triangles of a primitive.
void add_primitive(const GltfModel& model, const JsonPlace& primitive, MeshSoup& soup);

}  // namespace ecods::scenes
