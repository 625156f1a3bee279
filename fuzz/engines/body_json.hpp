// Meshes and poses as JSON: of questions to an engine, and of scene files.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::fuzz {

inline nlohmann::ordered_json vector_json(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

// Adds "vertices" and "triangles" to an object.
inline void add_mesh(nlohmann::ordered_json& object, const Mesh& mesh) {
    auto vertices = nlohmann::ordered_json::array(), triangles = nlohmann::ordered_json::array();
    for (const Vec3& vertex : mesh.vertices()) vertices.push_back(vector_json(vertex));
    for (const Triangle& t : mesh.triangles()) triangles.push_back({t[0], t[1], t[2]});
    object["vertices"] = std::move(vertices);
    object["triangles"] = std::move(triangles);
}

// Adds "R", by rows, and "t" to an object.
inline void add_pose(nlohmann::ordered_json& object, const Pose& pose) {
    auto rows = nlohmann::ordered_json::array();
    for (int row = 0; row < 3; ++row) rows.push_back(vector_json(pose.R.row(row)));
    object["R"] = std::move(rows);
    object["t"] = vector_json(pose.t);
}

}  // namespace ecods::fuzz
