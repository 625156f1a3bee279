#include <map>
#include <string>

#include "scenes/io/extension.hpp"
#include "scenes/io/gltf_file.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

Scene read_any_file(const std::filesystem::path& file) {
    if (is_gltf_file(file)) return read_gltf_file(file);
    if (is_mesh_file(file)) {
        const std::string name = file.stem().string();
        Scene scene;
        scene.meshes.push_back({name, read_mesh_file(file)});
        scene.bodies.push_back({name, 0, {}});
        return scene;
    }
    if (lower_extension(file) == ".json") return read_scene_file(file);
    throw ReadError(file, "", "unknown kind of file; known are .obj, .off, .ply, .stl, .gltf, .glb and .json");
}

// Names that were given, and for each the number that was tried last for another body of that name.
using Names = std::map<std::string, int>;

std::string unused_name(const std::string& name, Names& names) {
    const auto known = names.find(name);
    if (known == names.end()) return name;
    std::string candidate;
    do {
        candidate = name + " (" + std::to_string(++known->second) + ")";
    } while (names.contains(candidate));
    return candidate;
}

void append(Scene& scene, Scene part, Names& names) {
    const std::size_t first_mesh = scene.meshes.size();
    const std::size_t first_body = scene.bodies.size();
    for (NamedMesh& mesh : part.meshes) scene.meshes.push_back(std::move(mesh));
    for (SceneBody& body : part.bodies) {
        body.name = unused_name(body.name, names);
        names.emplace(body.name, 1);
        body.mesh_index += first_mesh;
        scene.bodies.push_back(std::move(body));
    }
    if (scene.frames.size() < part.frames.size()) scene.frames.resize(part.frames.size());
    for (std::size_t i = 0; i < part.frames.size(); ++i) {
        for (const Move& move : part.frames[i].moves) {
            scene.frames[i].moves.push_back({move.body_index + first_body, move.pose});
        }
    }
}

}  // namespace

Scene read_files(std::span<const std::filesystem::path> files) {
    Scene scene;
    Names names;
    for (const std::filesystem::path& file : files) append(scene, read_any_file(file), names);
    return scene;
}

}  // namespace ecods::scenes
