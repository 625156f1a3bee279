#include "scenes/io/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "ecods/error.hpp"
#include "scenes/io/extension.hpp"
#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

std::vector<int> root_nodes(const GltfModel& model) {
    const tinygltf::Model& m = model.model;
    if (!m.scenes.empty()) {
        const int scene = m.defaultScene < 0 ? 0 : m.defaultScene;
        if (!is_index_of(scene, m.scenes)) model.fail("scene", fmt::format("scene {} does not exist", scene));
        return m.scenes[scene].nodes;
    }
    std::set<int> children;
    for (const tinygltf::Node& node : m.nodes) children.insert(node.children.begin(), node.children.end());
    std::vector<int> roots;
    for (int i = 0; is_index_of(i, m.nodes); ++i) {
        if (!children.contains(i)) roots.push_back(i);
    }
    return roots;
}

Pose product(const Pose& parent, const Pose& child) {
    return {parent.R * child.R, parent.R * child.t + parent.t};
}

// The poses of the nodes of the scene, by node. The hierarchy must be a forest: else a body would be two, or none.
std::vector<std::optional<Pose>> world_poses(const GltfModel& model) {
    const tinygltf::Model& m = model.model;
    std::vector<std::optional<Pose>> poses(m.nodes.size());
    std::vector<std::pair<int, Pose>> stack;  // a node and the pose of its parent
    for (const int root : root_nodes(model)) stack.emplace_back(root, Pose{});
    while (!stack.empty()) {
        const auto [index, parent] = stack.back();
        stack.pop_back();
        const std::string place = fmt::format("nodes[{}]", index);
        if (!is_index_of(index, m.nodes)) model.fail(place, "this node does not exist");
        if (poses[index]) model.fail(place, "this node is reached twice: the hierarchy is not a tree");
        poses[index] = product(parent, local_pose(model, place, m.nodes[index]));
        for (const int child : m.nodes[index].children) stack.emplace_back(child, *poses[index]);
    }
    return poses;
}

std::shared_ptr<const Mesh> read_mesh(const GltfModel& model, int index) {
    const std::string place = fmt::format("meshes[{}]", index);
    const auto& primitives = model.model.meshes[index].primitives;
    MeshSoup soup;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        add_primitive(model, fmt::format("{}.primitives[{}]", place, i), primitives[i], soup);
    }
    return make_mesh(model.file, place, std::move(soup));
}

}  // namespace

bool is_gltf_file(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gltf" || extension == ".glb";
}

Scene read_gltf_file(const std::filesystem::path& file) {
    const GltfModel model = load_gltf(file);
    const std::vector<std::optional<Pose>> poses = world_poses(model);
    Scene scene;
    std::map<int, std::size_t> mesh_indices;  // from glTF's to the scene's
    std::set<std::string> names;
    for (int i = 0; is_index_of(i, poses); ++i) {
        const tinygltf::Node& node = model.model.nodes[i];
        if (!poses[i] || node.mesh < 0) continue;
        const std::string place = fmt::format("nodes[{}]", i);
        if (!is_index_of(node.mesh, model.model.meshes)) model.fail(place + ".mesh", "this mesh does not exist");
        if (node.skin >= 0) model.fail(place + ".skin", "skinned meshes are not supported");
        try {
            validate(*poses[i]);
        } catch (const Error& error) {
            model.fail(place, error.what());
        }
        const auto [entry, is_new] = mesh_indices.try_emplace(node.mesh, scene.meshes.size());
        if (is_new) scene.meshes.push_back({model.model.meshes[node.mesh].name, read_mesh(model, node.mesh)});
        std::string name = node.name.empty() ? fmt::format("node {}", i) : node.name;
        while (names.contains(name)) name += fmt::format(" (node {})", i);
        names.insert(name);
        scene.bodies.push_back({name, entry->second, *poses[i]});
    }
    if (scene.bodies.empty()) model.fail("", "no node of the scene has a mesh");
    return scene;
}

}  // namespace ecods::scenes
