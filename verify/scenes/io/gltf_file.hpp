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
// a mesh are joined: triangles, strips and fans. A body is named after its node; if that has no name, after its mesh;
// if that has none either, "node N". Where several bodies would have one name, each gets " (node N)" behind it.
//
// A node's "extras" may have a "motion": [x, y, z], as a body of a scene file (scene_file.hpp), in the coordinates of
// the scene.
//
// Buffers are files (read_bytes.hpp says which), data in base64, or come with a binary file; each has as many bytes as
// byteLength says.
//
// Throws ReadError for what is malformed, with the place in the file ("nodes[2].mesh") or the line. Numbers are never
// cut to fit: an index beyond 32 bits is an error. So is whatever would change a body and is not supported: glTF 1.0,
// points and lines, skinned meshes, morph targets whose weight is not zero, compressed, quantised or sparse geometry,
// instancing. Scene::notes says which animations and morph targets are left out, and how many nodes with a mesh are not
// in the scene. Cameras, lights and materials are ignored.
Scene read_gltf_file(const std::filesystem::path& file);

}  // namespace ecods::scenes
