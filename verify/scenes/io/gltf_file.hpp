// Assemblies from glTF 2 files (.gltf, .glb).
#pragma once

#include <filesystem>

#include "scenes/io/read_error.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Whether the extension, in lower or upper case, is .gltf or .glb.
bool is_gltf_file(const std::filesystem::path& file);

// Reads the default scene (the first if none is named; all nodes if there is no scene). Every node with a mesh is a
// body under its pose accumulated in double precision, bodies in the order of the nodes in the file. All primitives of
// a mesh are joined: triangles, strips and fans. Bodies are named after their node, or "node N"; a name that is taken
// gets " (node N)" behind it.
//
// Throws ReadError, with the place in the file, for what is malformed and for what would be left out in silence: points
// and lines, skinned meshes, compressed, quantised or sparse geometry, instancing. Animations, morph targets, cameras,
// lights and materials are ignored.
Scene read_gltf_file(const std::filesystem::path& file);

}  // namespace ecods::scenes
