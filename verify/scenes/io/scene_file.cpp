#include "scenes/io/scene_file.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "ecods/error.hpp"
#include "ecods/turn.hpp"
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

// Reads the meshes of a scene one by one; a file that several of them name, once.
class SceneMeshes {
  public:
    SceneMeshes(NamedFiles allowed, Scene& scene) : allowed_(allowed), scene_(scene) {}

    std::shared_ptr<const Mesh> read(const JsonPlace& place) {
        const auto mesh_file = place.find("file");
        if (!mesh_file) {
            place.check_keys({"name", "vertices", "triangles"});
            return read_inline_mesh(place);
        }
        place.check_keys({"name", "file"});
        const std::filesystem::path file = named_file(*mesh_file, mesh_file->text(), allowed_);
        auto& mesh = files_[file.lexically_normal()];
        if (mesh) return mesh;
        PolygonCounts polygons;
        mesh = read_mesh_file(file, &polygons);
        add_polygon_counts(file, polygons, scene_);
        return mesh;
    }

  private:
    NamedFiles allowed_;
    Scene& scene_;
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> files_;
};

// A body turns from where the frame before leaves it.
Move read_turning_move(const JsonPlace& place, std::size_t body, const Pose& from) {
    const JsonPlace turn_place = place.at("turn");
    const Turn turn = read_turn(turn_place);
    try {
        const Pose to = pose_at(from, turn, 1);
        validate(to);
        return {body, to, turn};
    } catch (const InvalidArgument& error) {
        turn_place.fail(fmt::format("the body ends where no double is: {}", error.what()));
    }
}

// Leaves the poses of all bodies at the end of the frame in `poses`.
Frame read_frame(const JsonPlace& place, const Names& bodies, std::vector<Pose>& poses) {
    place.check_keys({"moves"});
    Frame frame;
    std::set<std::size_t> moved;
    for (const JsonPlace& move : place.at("moves").elements()) {
        move.check_keys({"body", "pose", "turn"});
        const bool is_turn = move.find("turn").has_value();
        if (is_turn && move.find("pose")) move.fail("a move has a \"pose\" or a \"turn\", not both");
        const std::size_t body = find_name(move.at("body"), bodies, "body");
        if (!moved.insert(body).second) move.fail("the body is moved twice in one frame");
        frame.moves.push_back(is_turn ? read_turning_move(move, body, poses[body])
                                      : Move{body, read_pose(move.at("pose"))});
        poses[body] = frame.moves.back().pose;
    }
    return frame;
}

std::vector<Frame> read_frames(const JsonPlace& place, const Names& names, const std::vector<SceneBody>& bodies) {
    std::vector<Pose> poses;
    for (const SceneBody& body : bodies) poses.push_back(body.pose);
    std::vector<Frame> frames;
    for (const JsonPlace& frame : place.elements()) frames.push_back(read_frame(frame, names, poses));
    return frames;
}

}  // namespace

Scene read_scene_file(const std::filesystem::path& file, NamedFiles allowed) {
    const JsonDocument document = read_json(file);
    const JsonPlace root(file, *document);
    root.check_keys({"meshes", "bodies", "frames"});
    Scene scene;
    Names meshes;
    SceneMeshes reader(allowed, scene);
    for (const JsonPlace& place : root.at("meshes").elements()) {
        const std::string name = add_name(place, meshes);
        scene.meshes.push_back({name, reader.read(place)});
    }
    Names bodies;
    for (const JsonPlace& place : root.at("bodies").elements()) {
        place.check_keys({"name", "mesh", "pose", "motion", "turn"});
        SceneBody body;
        body.name = add_name(place, bodies);
        body.mesh_index = find_name(place.at("mesh"), meshes, "mesh");
        if (const auto pose = place.find("pose")) body.pose = read_pose(*pose);
        if (const auto motion = place.find("motion")) body.motion = motion->point();
        if (const auto turn = place.find("turn")) body.turn = read_turn(*turn);
        if (body.motion && body.turn) place.fail("a body has a \"motion\" or a \"turn\", not both");
        scene.bodies.push_back(std::move(body));
    }
    if (const auto frames = root.find("frames")) scene.frames = read_frames(*frames, bodies, scene.bodies);
    return scene;
}

}  // namespace ecods::scenes
