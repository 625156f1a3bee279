// Scenes from files.
//
// A scene file is JSON:
//
//     {
//       "meshes": [
//         { "name": "crate", "file": "crate.obj" },
//         { "name": "floor", "vertices": [[0, 0, 0], [9, 0, 0], [0, 9, 0]], "triangles": [[0, 1, 2]] }
//       ],
//       "bodies": [
//         { "name": "ground", "mesh": "floor" },
//         { "name": "box", "mesh": "crate", "pose": { "R": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "t": [1, 2, 0.5] } }
//       ],
//       "frames": [
//         { "moves": [ { "body": "box", "pose": { "t": [1, 2, 0.25] } } ] },
//         { "moves": [] }
//       ]
//     }
//
// A mesh comes from a file (relative to the scene file) or is given inline. A pose maps v to R v + t, R by rows; what
// is left out is the identity or zero. "frames" may be left out; the poses of "bodies" are frame 0, and each frame
// moves some bodies and leaves the others where they are. Numbers become the nearest doubles. Names are unique. Unknown
// keys are errors, but for those that begin with "_", which are comments.
#pragma once

#include <filesystem>
#include <span>

#include "scenes/io/read_error.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Reads a scene file. Throws ReadError with the line, or with the place such as "bodies[3].pose.R".
Scene read_scene_file(const std::filesystem::path& file);

// Reads any files into one scene, by extension: mesh files (a body each, at the identity, named after the file), glTF
// assemblies, and scene files (.json). Frames of several files run side by side. A name that is taken gets " (2)",
// " (3)" ... behind it. Throws ReadError.
Scene read_files(std::span<const std::filesystem::path> files);

}  // namespace ecods::scenes
