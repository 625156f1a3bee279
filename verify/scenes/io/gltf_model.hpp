// The parts of reading glTF; for gltf_*.cpp only.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "ecods/pose.hpp"
#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {

struct GltfModel {
    std::filesystem::path file;
    tinygltf::Model model;

    [[noreturn]] void fail(const std::string& place, const std::string& text) const {
        throw ReadError(file, place, text);
    }
};

// Parses the file and reads its buffers; nothing in the model is checked but that it is JSON of about the right form.
GltfModel load_gltf(const std::filesystem::path& file);

// The pose of a node relative to its parent, from its matrix or its translation, rotation and scale.
Pose local_pose(const GltfModel& model, const std::string& place, const tinygltf::Node& node);

// Adds the triangles of a primitive.
void add_primitive(const GltfModel& model, const std::string& place, const tinygltf::Primitive& primitive,
                   MeshSoup& soup);

// Whether `index` names an element of `list`.
template <class List>
bool is_index_of(int index, const List& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

}  // namespace ecods::scenes
