// A scene as plain data: meshes, the bodies made of them, and how the bodies move. It is what files are read into and
// what programs, tests and benchmarks run; it knows no World.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/polygon/polygon_counts.hpp"

namespace ecods::scenes {

struct NamedMesh {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  // never null
};

// A body at rest. It has a motion or a turn by which it is to be cast, or neither.
struct SceneBody {
    std::string name;            // for people; unique in scenes that were read from files
    std::size_t mesh_index = 0;  // in Scene::meshes
    Pose pose;
    std::optional<Vec3> motion = {};
    std::optional<Turn> turn = {};
};

// A body is given a new pose. It goes there straight, or by a turn, whose end is the pose but for its rounding.
struct Move {
    std::size_t body_index = 0;  // in Scene::bodies
    Pose pose;
    std::optional<Turn> turn = {};
};

// What changes with one step. Bodies that are not named stay where they are.
struct Frame {
    std::vector<Move> moves;
};

struct FilePolygons {
    std::string file;
    PolygonCounts counts;
};

// The poses of `bodies` are the rest, frame 0; `frames[i]` leads from frame i to frame i + 1.
struct Scene {
    std::vector<NamedMesh> meshes;
    std::vector<SceneBody> bodies;
    std::vector<Frame> frames;
    std::vector<std::string> notes;           // "FILE: TEXT": what a file has, and the scene has not, or has otherwise
    std::vector<FilePolygons> polygons = {};  // of files of which some are no fans, or in no plane
};

}  // namespace ecods::scenes
