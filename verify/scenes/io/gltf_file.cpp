#include "scenes/io/gltf_file.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ecods/error.hpp"
#include "scenes/io/body_names.hpp"
#include "scenes/io/extension.hpp"
#include "scenes/io/gltf_mesh.hpp"
#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

// The name of a node or a mesh; "" if it has none.
std::string name_of(const JsonPlace& place) {
    const auto name = place.find("name");
    return !name || name->value() == "" ? "" : name->text();
}

// Sets how the body is to be cast. Extras are whatever a program likes, so only a list is taken for a motion, and only
// an object for a turn.
void read_extras(const JsonPlace& node, SceneBody& body) {
    const auto extras = node.find("extras");
    if (!extras || !extras->value().is_object()) return;
    if (const auto motion = extras->find("motion"); motion && motion->value().is_array()) body.motion = motion->point();
    if (const auto turn = extras->find("turn"); turn && turn->value().is_object()) body.turn = read_turn(*turn);
    if (body.motion && body.turn) extras->fail("a body has a \"motion\" or a \"turn\", not both");
}

// Targets change no vertex as long as their weights are zero, which they are where none is given.
void check_weights(const JsonPlace& weights) {
    for (const JsonPlace& weight : weights.elements()) {
        if (weight.number() != 0) weight.fail("morph targets are not supported: a weight is not zero");
    }
}

// Counts of parts of the file that are left out, or read at rest.
struct Counts {
    std::size_t morphed_meshes = 0;
    std::size_t points_or_lines = 0;  // primitives
    std::size_t skinned_nodes = 0;
};

// Reads nodes one by one into a scene.
class SceneOfNodes {
  public:
    SceneOfNodes(GltfModel& model, const std::vector<std::optional<Pose>>& poses) : model_(model), poses_(poses) {}

    // The node is in the scene and has a mesh.
    void add(std::size_t index, const JsonPlace& node) {
        const JsonPlace mesh_index = node.at("mesh");
        const JsonPlace mesh = model_.target(mesh_index, "meshes");
        const auto skin = node.find("skin");
        if (const auto weights = node.find("weights")) {
            check_weights(*weights);
        } else if (const auto default_weights = mesh.find("weights")) {
            if (weighed_.insert(mesh_index.index()).second) check_weights(*default_weights);
        }
        const auto [entry, is_new] = meshes_.try_emplace({mesh_index.index(), skin ? std::int64_t{skin->index()} : -1});
        if (is_new) entry->second = add_mesh(mesh_index, mesh, skin);
        if (!entry->second) return;
        // A skinned mesh is where its joints are.
        const Pose pose = skin ? Pose{} : *poses_[index];
        try {
            validate(pose);
        } catch (const Error& error) {
            node.fail(error.what());
        }
        if (skin) ++counts_.skinned_nodes;
        std::string name = name_of(node).empty() ? name_of(mesh) : name_of(node);
        if (name.empty()) name = fmt::format("node {}", index);
        read_extras(node, scene_.bodies.emplace_back(SceneBody{std::move(name), *entry->second, pose}));
        node_indices_.push_back(index);
    }

    Scene take() {
        tell_names_apart();
        return std::move(scene_);
    }

    const Counts& counts() const noexcept { return counts_; }

  private:
    // The mesh in the scene, or nothing if there are only points and lines. Meshes that name the same triangles are
    // one.
    std::optional<std::size_t> add_mesh(const JsonPlace& index, const JsonPlace& mesh,
                                        const std::optional<JsonPlace>& skin) {
        const GltfGeometry geometry = geometry_of(mesh);
        const bool has_other_primitives = count(index, mesh);
        if (geometry.empty() && has_other_primitives) return std::nullopt;
        if (!skin) {
            if (const auto found = geometries_.find(geometry); found != geometries_.end()) return found->second;
        }
        const std::size_t place = scene_.meshes.size();
        const std::vector<Pose>* joints = skin ? &joints_of(*skin) : nullptr;
        scene_.meshes.push_back({name_of(mesh), make_mesh(mesh, read_primitives(model_, mesh, joints))});
        if (!skin) geometries_[geometry] = place;
        return place;
    }

    // Counts what is left out of a mesh, the first time. True if some of its primitives are points or lines.
    bool count(const JsonPlace& index, const JsonPlace& mesh) {
        const bool is_new = counted_.insert(index.index()).second;
        std::size_t points_or_lines = 0;
        bool has_targets = false;
        for (const JsonPlace& primitive : mesh.at("primitives").elements()) {
            if (is_points_or_lines(primitive)) ++points_or_lines;
            if (primitive.find("targets")) has_targets = true;
        }
        if (is_new) counts_.points_or_lines += points_or_lines;
        if (is_new && has_targets) ++counts_.morphed_meshes;
        return points_or_lines > 0;
    }

    const std::vector<Pose>& joints_of(const JsonPlace& skin) {
        const auto [entry, is_new] = joints_.try_emplace(skin.index());
        if (is_new) entry->second = joint_poses(model_, model_.target(skin, "skins"), poses_);
        return entry->second;
    }

    // All bodies of one name get their node behind it; twice, where another node bears even that name.
    void tell_names_apart() {
        std::vector<bool> is_alone(scene_.bodies.size(), true);
        for (const std::vector<std::size_t>& group : bodies_of_one_name(scene_)) {
            for (const std::size_t i : group) is_alone[i] = false;
        }
        // New names end with different numbers, so a new name can only be that of a body that keeps its own.
        std::set<std::string> taken;
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            const std::string& name = scene_.bodies[i].name;
            if (is_alone[i] && name.ends_with(')')) taken.insert(name);
        }
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            if (is_alone[i]) continue;
            std::string& name = scene_.bodies[i].name;
            do {
                name += fmt::format(" (node {})", node_indices_[i]);
            } while (taken.contains(name));
        }
    }

    GltfModel& model_;
    const std::vector<std::optional<Pose>>& poses_;  // by node
    Scene scene_;
    // From glTF's mesh and skin (-1: none) to the scene's mesh.
    std::map<std::pair<std::uint32_t, std::int64_t>, std::optional<std::size_t>> meshes_;
    std::map<GltfGeometry, std::size_t> geometries_;
    std::map<std::uint32_t, std::vector<Pose>> joints_;  // by skin
    std::set<std::uint32_t> weighed_, counted_;          // meshes
    std::vector<std::size_t> node_indices_;              // by body
    Counts counts_;
};

std::string counted(std::size_t count, std::string_view thing) {
    const std::string_view ending = count == 1 ? "" : thing.ends_with("mesh") ? "es" : "s";
    return fmt::format("{} {}{}", count, thing, ending);
}

std::vector<std::string> notes_of(const GltfModel& model, const Counts& counts, std::size_t nodes_left_out) {
    std::vector<std::string> notes;
    const auto note = [&](const std::string& text) { notes.push_back(model.file.string() + ": " + text); };
    const auto animations = model.root().find("animations");
    if (animations && animations->size() > 0)
        note("left out: " + counted(animations->size(), "animation") + "; bodies are where their nodes rest");
    if (counts.morphed_meshes > 0) {
        note("left out: morph targets of " + counted(counts.morphed_meshes, "mesh") +
             "; their weights are zero at rest");
    }
    if (counts.points_or_lines > 0)
        note("left out: " + counted(counts.points_or_lines, "primitive") + " of points or lines");
    if (nodes_left_out > 0)
        note("left out: " + counted(nodes_left_out, "node") + " with a mesh, not in the default scene");
    if (counts.skinned_nodes > 0)
        note("at rest: " + counted(counts.skinned_nodes, "skinned node") + "; vertices are rounded to doubles");
    return notes;
}

}  // namespace

bool is_gltf_file(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gltf" || extension == ".glb";
}

Scene read_gltf_file(const std::filesystem::path& file, NamedFiles allowed) {
    GltfModel model = load_gltf(file, allowed);
    const std::vector<std::optional<Pose>> poses = world_poses(model);
    SceneOfNodes nodes(model, poses);
    std::size_t left_out = 0;
    const auto list = model.root().find("nodes");
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const JsonPlace node = list->element(i);
        if (!node.find("mesh")) continue;
        if (poses[i]) {
            nodes.add(i, node);
        } else {
            ++left_out;
        }
    }
    Scene scene = nodes.take();
    if (scene.bodies.empty()) {
        const bool has_lines = nodes.counts().points_or_lines > 0;
        model.root().fail(has_lines ? "there are only points and lines, and no triangles"
                                    : "no node of the scene has a mesh");
    }
    scene.notes = notes_of(model, nodes.counts(), left_out);
    return scene;
}

}  // namespace ecods::scenes
