#include "fuzz/engines/dump.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "fuzz/engines/body_json.hpp"
#include "report/povray.hpp"

namespace ecods::fuzz {
namespace {

using Json = nlohmann::ordered_json;

Json mesh_json(const std::string& name, const Mesh& mesh) {
    Json json = {{"name", name}};
    add_mesh(json, mesh);
    return json;
}

Json body_json(const std::string& name, const Pose& pose) {
    Json json = {{"name", name}, {"mesh", "mesh of " + name}};
    add_pose(json["pose"], pose);
    return json;
}

std::string file_name(const WrongAnswer& wrong) {
    std::string name = fmt::format("{}-{}-{}", wrong.engine, wrong.family, wrong.query);
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '.'; }, '_');
    return name;
}

// Both bodies as a whole, from where the two are beside each other; one is orange.
void paint(const scenes::MeshPairs& pairs, const scenes::MeshQuery& query, const std::string& name,
           const std::filesystem::path& folder) {
    // Far from the origin a picture's floats would say nothing: it is taken around the first body's origin.
    const Vec3 origin = query.a.pose.t;
    scenes::Scene scene;
    std::vector<bench::PaintedBody> bodies;
    std::vector<Vec3> centers;
    double radius = 0;
    for (const scenes::MeshAt& at : {query.a, query.b}) {
        scene.meshes.push_back(pairs.meshes[at.mesh_index]);
        Pose pose = at.pose;
        pose.t -= origin;
        scene.bodies.push_back({.name = bodies.empty() ? "a" : "b", .mesh_index = bodies.size(), .pose = pose});
        bodies.push_back({pose, bodies.empty() ? bench::Paint::plain : bench::Paint::crossing, {}});
        Vec3 low = Vec3::Constant(1e300), high = -low;
        for (const Vec3& vertex : scene.meshes.back().mesh->vertices()) {
            const Vec3 point = pose.R * vertex + pose.t;
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        centers.emplace_back((low + high) / 2);
        radius = std::max(radius, (high - low).norm() / 2);
    }
    const Vec3 middle = (centers[0] + centers[1]) / 2;
    Vec3 side = (centers[1] - centers[0]).cross(Vec3::UnitZ());
    side = side.norm() > 0 ? Vec3(side.normalized()) : Vec3::UnitX();
    const double reach = radius + (centers[1] - centers[0]).norm() / 2;
    const bench::View view{.name = name,
                           .eye = middle + 3.2 * reach * (side + 0.45 * Vec3::UnitZ()).normalized(),
                           .target = middle,
                           .width = 640,
                           .height = 480};
    bench::draw(scene, bodies, view, folder, "");
    std::filesystem::remove(folder / (name + ".pov"));
}

}  // namespace

std::filesystem::path dump(const WrongAnswer& wrong, const scenes::MeshPairs& pairs,
                           const std::filesystem::path& folder, bool has_picture) {
    std::filesystem::create_directories(folder);
    const scenes::MeshQuery& query = pairs.queries.at(wrong.query);
    const std::string name = file_name(wrong);
    const std::filesystem::path file = folder / (name + ".json");
    const Json scene = {{"_engine", wrong.engine},
                        {"_family", wrong.family},
                        {"_query", wrong.query},
                        {"_truth", wrong.touches ? "they share a point" : "they share no point"},
                        {"_wrong", "said of a and b, or of b and a, the opposite"},
                        {"meshes",
                         {mesh_json("mesh of a", *pairs.meshes[query.a.mesh_index].mesh),
                          mesh_json("mesh of b", *pairs.meshes[query.b.mesh_index].mesh)}},
                        {"bodies", {body_json("a", query.a.pose), body_json("b", query.b.pose)}}};
    std::ofstream out(file);
    out << scene.dump(1) << "\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
    if (has_picture) paint(pairs, query, name, folder);
    return file;
}

}  // namespace ecods::fuzz
