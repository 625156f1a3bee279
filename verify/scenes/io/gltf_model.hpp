// The parts of reading glTF; for gltf_*.cpp only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ecods/pose.hpp"
#include "scenes/io/json_file.hpp"
#include "scenes/io/json_place.hpp"
#include "scenes/io/named_file.hpp"

namespace ecods::scenes {

struct GltfModel {
    std::filesystem::path file;
    JsonDocument document;
    std::vector<std::shared_ptr<const std::string>> buffers;  // bytes; buffers of one file share them
    bool is_quantized = false;                                // KHR_mesh_quantization is used
    std::uint64_t elements_max = 0;                           // of accessors, that may be read
    std::uint64_t elements_read = 0;

    // Refers to the model, as all that is reached from it does.
    JsonPlace root() const { return {file, *document}; }

    // The element of one of the lists at the root that `index` names. Throws ReadError at `index` if there is none.
    JsonPlace target(const JsonPlace& index, const char* list) const;

    // Counts elements that are about to be read. Throws ReadError at `place` beyond elements_max: accessors can be
    // named over and over, so the work would grow with the square of the file.
    void spend(const JsonPlace& place, std::uint64_t count);
};

// Reads the file and its buffers. Checked: the version, the containers and extensions; not what the JSON describes.
// Buffers are files as named_file() allows.
GltfModel load_gltf(const std::filesystem::path& file, NamedFiles allowed);

// Reads the buffers of a model one by one; a file that several of them name, once.
class GltfBuffers {
  public:
    explicit GltfBuffers(NamedFiles allowed) : allowed_(allowed) {}

    // The bytes of a buffer: from its URI, or, where it has none, the bytes that come in the file itself ("" if none
    // do).
    std::shared_ptr<const std::string> read(const JsonPlace& buffer, std::string_view embedded);

    std::uint64_t file_bytes() const noexcept { return file_bytes_; }  // of all files that were read

  private:
    std::shared_ptr<const std::string> read_uri(const JsonPlace& place);

    NamedFiles allowed_;
    std::map<std::filesystem::path, std::shared_ptr<const std::string>> files_;
    std::uint64_t file_bytes_ = 0;
};

// The pose of a node relative to its parent, from its matrix or its translation, rotation and scale.
Pose local_pose(const JsonPlace& node);

// The pose of a matrix by columns. Throws ReadError at `place` unless the last row is 0 0 0 1.
Pose pose_of_matrix(const JsonPlace& place, std::span<const double, 16> values);

// The pose that maps as `child` does, and then as `parent`; rounded.
Pose product(const Pose& parent, const Pose& child);

// The poses of the nodes of the scene, by node, accumulated in double precision; nothing for nodes outside it. Throws
// ReadError unless the hierarchy is a forest: a body would be two, or none.
std::vector<std::optional<Pose>> world_poses(const GltfModel& model);

}  // namespace ecods::scenes
