#include <new>
#include <stdexcept>
#include <string>

#include "scenes/io/body_names.hpp"
#include "scenes/io/extension.hpp"
#include "scenes/io/gltf_file.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/polygon_notes.hpp"
#include "scenes/io/read_bytes.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

// A body for each part, named as the part is; as the file is, where that has no name or is the only one.
Scene scene_of_parts(const std::filesystem::path& file) {
    Scene scene;
    PolygonCounts polygons;
    std::vector<NamedMesh> parts = read_mesh_parts(file, &polygons);
    add_polygon_counts(file, polygons, scene);
    const bool is_one = parts.size() == 1;
    for (NamedMesh& part : parts) {
        if (is_one || part.name.empty()) part.name = file.stem().string();
        scene.bodies.push_back({part.name, scene.meshes.size(), {}});
        scene.meshes.push_back(std::move(part));
    }
    return scene;
}

void append(Scene& scene, Scene part) {
    const std::size_t first_mesh = scene.meshes.size();
    const std::size_t first_body = scene.bodies.size();
    for (NamedMesh& mesh : part.meshes) scene.meshes.push_back(std::move(mesh));
    for (SceneBody& body : part.bodies) {
        body.mesh_index += first_mesh;
        scene.bodies.push_back(std::move(body));
    }
    if (scene.frames.size() < part.frames.size()) scene.frames.resize(part.frames.size());
    for (std::size_t i = 0; i < part.frames.size(); ++i) {
        for (const Move& move : part.frames[i].moves) {
            scene.frames[i].moves.push_back({move.body_index + first_body, move.pose, move.turn});
        }
    }
    for (std::string& note : part.notes) scene.notes.push_back(std::move(note));
    for (FilePolygons& polygons : part.polygons) scene.polygons.push_back(std::move(polygons));
}

}  // namespace

Scene read_file(const std::filesystem::path& file, NamedFiles allowed) try {
    if (is_gltf_file(file)) return read_gltf_file(file, allowed);
    if (is_mesh_file(file)) return scene_of_parts(file);
    if (lower_extension(file) == ".json") return read_scene_file(file, allowed);
    require_regular_file(file);
    throw ReadError(file, "", "unknown kind of file; known are .obj, .off, .ply, .stl, .gltf, .glb and .json");
} catch (const std::bad_alloc&) {
    throw ReadError(file, "", "out of memory");
} catch (const std::length_error&) {
    throw ReadError(file, "", "out of memory");  // no memory could have this size
}

Scene join_files(std::vector<FileScene> files) {
    Scene scene;
    std::vector<BodyOrigin> origins;
    for (FileScene& part : files) {
        const bool is_file = is_mesh_file(part.file) && part.scene.bodies.size() == 1;
        origins.insert(origins.end(), part.scene.bodies.size(), {part.file.string(), is_file});
        append(scene, std::move(part.scene));
    }
    make_names_unique(scene, origins);
    return scene;
}

Scene read_files(std::span<const std::filesystem::path> files, NamedFiles allowed) {
    std::vector<FileScene> parts;
    std::vector<ReadError> errors;
    for (const std::filesystem::path& file : files) {
        try {
            parts.push_back({file, read_file(file, allowed)});
        } catch (const ReadError& error) {
            errors.push_back(error);
        }
    }
    if (!errors.empty()) throw ReadErrors(std::move(errors));
    return join_files(std::move(parts));
}

}  // namespace ecods::scenes
