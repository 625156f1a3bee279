// Assemblies from glTF 2 files (.gltf, .glb).
#pragma once

#include <filesystem>

#include "scenes/io/named_file.hpp"
#include "scenes/io/read_error.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Whether the extension, in lower or upper case, is .gltf or .glb.
bool is_gltf_file(const std::filesystem::path& file);

// Reads the default scene (the first if none is named; all nodes if there is no scene). Every node with a mesh is a
// body under its pose accumulated in double precision, bodies in the order of the nodes in the file. All primitives of
// a mesh are joined: triangles, strips and fans; those of points or lines are left out, and a mesh of nothing else is
// no body. A mesh has the vertices that its triangles use, in the order of the file; one that primitives name together,
// by one accessor, stands once. Meshes whose primitives name the same accessors are one mesh of the scene. A body is
// named after its node; if that has no name, after its mesh; if that has none either, "node N". Where several bodies
// would have one name, each gets " (node N)" behind it.
//
// A node's "extras" may have a "motion": [x, y, z] or a "turn": {...}, as a body of a scene file has them
// (scene_file.hpp), in the coordinates of the scene, and with the same errors. Another value than a list and an object
// is somebody's own.
//
// Buffers are files (named_file.hpp says which), data in base64, or come with a binary file; each has as many bytes as
// byteLength says.
//
// Accessors may be sparse, and positions quantised (KHR_mesh_quantization). Coordinates are the doubles in the file,
// but for two kinds: a normalised one is rounded once, to the double nearest to c / 127, c / 255, c / 32767 or c /
// 65535; and the vertices of a skinned mesh are placed by its joints as these rest, computed in double precision
// (GltfSkinning), and its body has the identity for its pose, whatever its node says. Poses of nodes are accumulated,
// and never applied to vertices.
//
// Time and memory are proportional to the file and its buffers (times a logarithm). Accessors can be named over and
// over, so at most eight of their elements are read for each byte, and 2^20.
//
// Throws ReadError for what is malformed, with the place in the file ("nodes[2].mesh") or the line. Numbers are never
// cut to fit: an index beyond 32 bits is an error. So is whatever would change a body and is not supported: glTF 1.0,
// morph targets whose weight is not zero, compressed geometry, instancing, and each extension that the file requires,
// unless it is about materials, textures or lights. Scene::notes says which animations, morph targets and primitives
// are left out, how many nodes with a mesh are not in the scene, and how many are skinned. Cameras, lights and
// materials are ignored.
Scene read_gltf_file(const std::filesystem::path& file, NamedFiles allowed = NamedFiles::anywhere);

}  // namespace ecods::scenes
