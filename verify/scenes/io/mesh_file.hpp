// Meshes from files: OBJ, OFF, PLY (text and binary), STL (text and binary).
#pragma once

#include <filesystem>
#include <memory>

#include "ecods/mesh.hpp"
#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// Whether the extension, in lower or upper case, is that of a mesh format.
bool is_mesh_file(const std::filesystem::path& file);

// Reads a mesh. Throws ReadError with the line, or the element of a binary file, for a file that is missing, of unknown
// extension, cut off or malformed, for numbers that are not finite doubles, for indices out of range and for a mesh
// without triangles. Memory and time are bounded by the size of the file, whatever its header says.
//
// Coordinates are the doubles nearest to the decimals in the file, bit for bit; those of binary files are taken as
// they are. Polygons are cut into fans around their first corner. Vertices keep their order. All groups, objects and
// solids of a file make one mesh. Normals, colours, textures, points, lines and curves are ignored.
//
// The readers are the project's own, because those of the libraries at hand do not serve: CGAL's accept damaged files
// (a face "1 2 x" has two corners), allocate what a header claims and name no line; Assimp's round to float.
std::shared_ptr<const Mesh> read_mesh_file(const std::filesystem::path& file);

}  // namespace ecods::scenes
