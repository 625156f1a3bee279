#include "programs/clash/inputs.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <utility>

#include "process/parallel.hpp"
#include "process/progress.hpp"
#include "programs/clash/convex_candidates.hpp"
#include "programs/clash/make_shape.hpp"
#include "scenes/io/gltf_file.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::clash {
namespace {

namespace fs = std::filesystem;

void find_in_folder(const fs::path& folder, scenes::NamedFiles allowed, std::vector<fs::path>& files) {
    const std::size_t count_before = files.size();
    try {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const bool is_known = scenes::is_mesh_file(entry.path()) || scenes::is_gltf_file(entry.path());
            if (!is_known || !entry.is_regular_file()) continue;
            if (allowed == scenes::NamedFiles::in_folder && !scenes::is_within(folder, entry.path()))
                throw scenes::ReadError(entry.path(), "", "is a link that leads out of its folder; --untrusted");
            files.push_back(entry.path());
        }
    } catch (const fs::filesystem_error& error) {
        throw scenes::ReadError(folder, "", error.code().message());
    }
    if (files.size() == count_before) throw scenes::ReadError(folder, "", "no mesh and no assembly is in this folder");
}

std::vector<MadeShape> make_shapes(const scenes::Scene& scene, std::size_t jobs) {
    const std::vector<scenes::NamedMesh>& meshes = scene.meshes;
    const std::vector<char> may_be_convex = find_convex_candidates(scene, jobs);
    std::vector<MadeShape> shapes(meshes.size());
    process::Progress progress("finding solids", meshes.size());
    process::for_each_in_parallel(meshes.size(), jobs, [&](std::size_t i, std::size_t) {
        shapes[i] = make_shape(meshes[i].mesh, may_be_convex[i] != 0);
        progress.step();
    });
    return shapes;
}

// What is read of each file, or why it is not.
struct ReadFile {
    std::optional<scenes::Scene> scene;
    std::optional<scenes::ReadError> error;
};

std::vector<ReadFile> read_all(const std::vector<fs::path>& files, const Reading& reading) {
    std::vector<ReadFile> read(files.size());
    process::Progress progress("reading", files.size());
    process::for_each_in_parallel(files.size(), reading.jobs, [&](std::size_t i, std::size_t) {
        try {
            read[i].scene = scenes::read_file(files[i], reading.named_files);
        } catch (const scenes::ReadError& error) {
            read[i].error = error;
        }
        progress.step();
    });
    return read;
}

std::vector<Part> make_parts(const scenes::Scene& scene, const std::vector<std::string>& file_of, std::size_t jobs) {
    const std::vector<MadeShape> shapes = make_shapes(scene, jobs);
    std::vector<std::size_t> order(scene.bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return scene.bodies[a].name < scene.bodies[b].name; });
    std::vector<Part> parts;
    parts.reserve(order.size());
    for (const std::size_t body : order) {
        const scenes::SceneBody& from = scene.bodies[body];
        const auto& [shape, reason] = shapes[from.mesh_index];
        parts.push_back({.name = from.name,
                         .file = file_of[body],
                         .group = "",
                         .shape = shape,
                         .pose = from.pose,
                         .is_solid = reason.empty(),
                         .not_solid_because = reason});
    }
    return parts;
}

}  // namespace

std::vector<fs::path> find_files(const std::vector<fs::path>& given, scenes::NamedFiles allowed) {
    std::vector<fs::path> files;
    for (const fs::path& path : given) {
        std::error_code error;
        if (fs::is_directory(path, error)) {
            find_in_folder(path, allowed, files);
        } else {
            files.push_back(path);
        }
    }
    for (fs::path& file : files) file = file.lexically_normal();
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

Inputs read_inputs(const std::vector<fs::path>& files, const Reading& reading) {
    Inputs inputs;
    std::vector<scenes::ReadError> errors;
    std::vector<scenes::FileScene> scenes;
    std::vector<std::string> file_of;  // by body
    const auto begin = std::chrono::steady_clock::now();
    std::vector<ReadFile> read = read_all(files, reading);
    inputs.reading_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (read[i].error) {
            inputs.failed.push_back({files[i].string(), read[i].error->what()});
            errors.push_back(*read[i].error);
            continue;
        }
        scenes::Scene& scene = *read[i].scene;
        if (!scene.frames.empty()) scene.notes.push_back(files[i].string() + ": only the rest, frame 0, is judged");
        file_of.insert(file_of.end(), scene.bodies.size(), files[i].string());
        scenes.push_back({files[i], std::move(scene)});
    }
    if (!errors.empty() && !reading.keeps_going) throw scenes::ReadErrors(std::move(errors));
    scenes::Scene scene = scenes::join_files(std::move(scenes));
    inputs.notes = std::move(scene.notes);
    std::sort(inputs.notes.begin(), inputs.notes.end());
    inputs.parts = make_parts(scene, file_of, reading.jobs);
    return inputs;
}

}  // namespace ecods::clash
