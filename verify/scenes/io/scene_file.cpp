#include "scenes/io/scene_file.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "scenes/io/json_file.hpp"
#include "scenes/io/json_place.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/polygon_notes.hpp"

namespace ecods::scenes {
namespace {

using Names = std::map<std::string, std::size_t>;  // to indices

std::string add_name(const JsonPlace& place, Names& names) {
    const JsonPlace name = place.at("name");
    if (!names.emplace(name.text(), names.size()).second)
        name.fail(fmt::format("the name \"{}\" is taken", name.text()));
    return name.text();
}

std::size_t find_name(const JsonPlace& place, const Names& names, const char* kind) {
    const auto entry = names.find(place.text());
    if (entry == names.end()) place.fail(fmt::format("there is no {} \"{}\"", kind, place.text()));
    return entry->second;
}

std::shared_ptr<const Mesh> read_mesh(const std::filesystem::path& file, const JsonPlace& place, Scene& scene) {
    const auto mesh_file = place.find("file");
    if (!mesh_file) {
        place.check_keys({"name", "vertices", "triangles"});
        return read_inline_mesh(file, place);
    }
    place.check_keys({"name", "file"});
    const std::filesystem::path path = file.parent_path() / mesh_file->text();
    PolygonCounts polygons;
    auto mesh = read_mesh_file(path, &polygons);
    add_polygon_counts(path, polygons, scene);
    return mesh;
}

Frame read_frame(const JsonPlace& place, const Names& bodies) {
    place.check_keys({"moves"});
    Frame frame;
    std::set<std::size_t> moved;
    for (const JsonPlace& move : place.at("moves").elements()) {
        move.check_keys({"body", "pose"});
        const std::size_t body = find_name(move.at("body"), bodies, "body");
        if (!moved.insert(body).second) move.fail("the body is moved twice in one frame");
        frame.moves.push_back({body, read_pose(move.at("pose"))});
    }
    return frame;
}

}  // namespace

Scene read_scene_file(const std::filesystem::path& file) {
    const nlohmann::json document = read_json(file);
    const JsonPlace root(file, document);
    root.check_keys({"meshes", "bodies", "frames"});
    Scene scene;
    Names meshes;
    for (const JsonPlace& place : root.at("meshes").elements()) {
        const std::string name = add_name(place, meshes);
        scene.meshes.push_back({name, read_mesh(file, place, scene)});
    }
    Names bodies;
    for (const JsonPlace& place : root.at("bodies").elements()) {
        place.check_keys({"name", "mesh", "pose", "motion"});
        SceneBody body;
        body.name = add_name(place, bodies);
        body.mesh_index = find_name(place.at("mesh"), meshes, "mesh");
        if (const auto pose = place.find("pose")) body.pose = read_pose(*pose);
        if (const auto motion = place.find("motion")) body.motion = motion->point();
        scene.bodies.push_back(std::move(body));
    }
    if (const auto frames = root.find("frames")) {
        for (const JsonPlace& frame : frames->elements()) scene.frames.push_back(read_frame(frame, bodies));
    }
    return scene;
}

}  // namespace ecods::scenes
