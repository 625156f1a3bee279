#include "scenes/io/gltf_file.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

#include "ecods/error.hpp"
#include "scenes/io/extension.hpp"
#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

// The name of a node or a mesh; "" if it has none.
std::string name_of(const JsonPlace& place) {
    const auto name = place.find("name");
    return !name || name->value() == "" ? "" : name->text();
}

// Extras are whatever a program likes, so only an array of this name is taken for one.
std::optional<Vec3> motion_of(const JsonPlace& node) {
    const auto extras = node.find("extras");
    if (!extras || !extras->value().is_object()) return std::nullopt;
    const auto motion = extras->find("motion");
    return motion && motion->value().is_array() ? std::optional(motion->point()) : std::nullopt;
}

// Targets change no vertex as long as their weights are zero, which they are where none is given.
bool has_morph_targets(const JsonPlace& place) {
    if (const auto weights = place.find("weights")) {
        for (const JsonPlace& weight : weights->elements()) {
            if (weight.number() != 0) weight.fail("morph targets are not supported: a weight is not zero");
        }
    }
    const auto primitives = place.find("primitives");
    if (!primitives) return false;
    bool has_targets = false;
    for (const JsonPlace& primitive : primitives->elements()) {
        if (primitive.find("targets")) has_targets = true;
    }
    return has_targets;
}

std::shared_ptr<const Mesh> read_mesh(const GltfModel& model, const JsonPlace& mesh) {
    MeshSoup soup;
    for (const JsonPlace& primitive : mesh.at("primitives").elements()) add_primitive(model, primitive, soup);
    return make_mesh(model.file, mesh.path(), std::move(soup));
}

// Reads nodes one by one into a scene.
class SceneOfNodes {
  public:
    explicit SceneOfNodes(const GltfModel& model) : model_(model) {}

    void add(std::size_t index, const JsonPlace& node, const Pose& pose) {
        const JsonPlace mesh_index = node.at("mesh");
        const JsonPlace mesh = model_.target(mesh_index, "meshes");
        if (const auto skin = node.find("skin")) skin->fail("skinned meshes are not supported");
        try {
            validate(pose);
        } catch (const Error& error) {
            node.fail(error.what());
        }
        has_morph_targets(node);
        const auto [entry, is_new] = mesh_indices_.try_emplace(mesh_index.index(), scene_.meshes.size());
        if (is_new) {
            scene_.meshes.push_back({name_of(mesh), read_mesh(model_, mesh)});
            if (has_morph_targets(mesh)) ++morphed_meshes_;
        }
        std::string name = name_of(node).empty() ? name_of(mesh) : name_of(node);
        if (name.empty()) name = fmt::format("node {}", index);
        scene_.bodies.push_back({std::move(name), entry->second, pose, motion_of(node)});
        node_indices_.push_back(index);
    }

    Scene take() {
        tell_names_apart();
        return std::move(scene_);
    }

    std::size_t morphed_meshes() const noexcept { return morphed_meshes_; }

  private:
    // All bodies of one name get their node behind it; twice, where another node bears even that name.
    void tell_names_apart() {
        std::map<std::string, int> uses;
        for (const SceneBody& body : scene_.bodies) ++uses[body.name];
        std::set<std::string> names;
        for (const auto& [name, count] : uses) {
            if (count == 1) names.insert(name);
        }
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            std::string& name = scene_.bodies[i].name;
            if (uses.at(name) == 1) continue;
            do {
                name += fmt::format(" (node {})", node_indices_[i]);
            } while (!names.insert(name).second);
        }
    }

    const GltfModel& model_;
    Scene scene_;
    std::map<std::uint32_t, std::size_t> mesh_indices_;  // from glTF's to the scene's
    std::vector<std::size_t> node_indices_;              // by body
    std::size_t morphed_meshes_ = 0;
};

std::string counted(std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : (thing.ends_with("mesh") ? "es" : "s"));
}

}  // namespace

bool is_gltf_file(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gltf" || extension == ".glb";
}

Scene read_gltf_file(const std::filesystem::path& file) {
    const GltfModel model = load_gltf(file);
    const std::vector<std::optional<Pose>> poses = world_poses(model);
    SceneOfNodes nodes(model);
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const JsonPlace node = model.root().at("nodes").element(i);
        if (!node.find("mesh")) continue;
        if (poses[i]) {
            nodes.add(i, node, *poses[i]);
        } else {
            ++left_out;
        }
    }
    Scene scene = nodes.take();
    if (scene.bodies.empty()) model.root().fail("no node of the scene has a mesh");
    const auto note = [&](const std::string& text) { scene.notes.push_back(file.string() + ": left out: " + text); };
    const auto animations = model.root().find("animations");
    if (animations && animations->size() > 0)
        note(counted(animations->size(), "animation") + "; bodies are where their nodes rest");
    if (nodes.morphed_meshes() > 0)
        note("morph targets of " + counted(nodes.morphed_meshes(), "mesh") + "; their weights are zero at rest");
    if (left_out > 0) note(counted(left_out, "node") + " with a mesh, not in the default scene");
    return scene;
}

}  // namespace ecods::scenes
