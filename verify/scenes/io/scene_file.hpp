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
//         { "name": "box", "mesh": "crate", "pose": { "R": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "t": [1, 2, 0.5] },
//           "motion": [0, 0, -1] }
//       ],
//       "frames": [
//         { "moves": [ { "body": "box", "pose": { "t": [1, 2, 0.25] } } ] },
//         { "moves": [ { "body": "box", "turn": { "axis": [0, 0, 1], "degrees": 30, "pivot": [1, 2, 0] } } ] },
//         { "moves": [] }
//       ]
//     }
//
// A mesh comes from a file (all of its parts as one; named_file.hpp says which files) or is given inline. A pose maps v
// to R v + t, R by rows; what is left out is the identity or zero. "frames" may be left out; the poses of "bodies" are
// frame 0, and each frame moves some bodies and leaves the others where they are. A move has a pose, to which the body
// goes straight, or a "turn" (include/ecods/turn.hpp), which it makes from where it is; it then is at the end of the
// turn, each entry of its pose rounded once. A turn has "q": [w, x, y, z], of any length, or an "axis" and either
// "degrees" or an "angle" in radians; a "pivot", in the coordinates of the scene; and where the pivot glides,
// "pivot_to". A body may have a "motion" or a "turn" of its own, which moves nothing: a program may ask what the body
// would meet if it made that, at any frame. Numbers become the nearest doubles. Names are unique, and so are the keys
// of an object. Unknown keys are errors, but for those that begin with "_", which are comments.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "scenes/io/named_file.hpp"
#include "scenes/io/read_error.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Reads a scene file. Throws ReadError with the line, or with the place such as "bodies[3].pose.R".
Scene read_scene_file(const std::filesystem::path& file, NamedFiles allowed = NamedFiles::anywhere);

// Reads a file by its extension: a mesh file, a glTF assembly or a scene file (.json). A mesh file is a body at the
// identity, named after the file; one of several parts (objects and groups of OBJ, solids of STL: see mesh_file.hpp) is
// a body for each, named after the part. Throws ReadError, also when memory runs out. Files may be read by several
// threads at once.
Scene read_file(const std::filesystem::path& file, NamedFiles allowed = NamedFiles::anywhere);

struct FileScene {
    std::filesystem::path file;
    Scene scene;
};

// Makes one scene of several files. Meshes and bodies stay in the order of the files. Frames of several files run side
// by side. Bodies of several paths that would have one name are named after their paths, "a/part.obj" or
// "a/assembly.obj: part"; those of one path that is given twice get " (2)" and so on.
Scene join_files(std::vector<FileScene> files);

// Reads any files into one scene. Throws ReadErrors with an error for every file that cannot be read.
Scene read_files(std::span<const std::filesystem::path> files, NamedFiles allowed = NamedFiles::anywhere);

}  // namespace ecods::scenes
