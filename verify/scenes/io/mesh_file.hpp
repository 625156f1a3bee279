// Meshes from files: OBJ, OFF, PLY (text and binary), STL (text and binary).
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "scenes/io/read_error.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Whether the extension, in lower or upper case, is that of a mesh format.
bool is_mesh_file(const std::filesystem::path& file);

// Reads a mesh: all parts of the file, as one. Throws ReadError with the line, or the element of a binary file, for a
// file that is missing, of unknown extension, cut off or malformed, for numbers that are not finite doubles or not of
// the type that is declared for them, for indices out of range and for a mesh without triangles. Nothing is passed over
// in silence: a word or a byte behind what a line, an item or the file should have is an error, and so is a keyword
// that the format does not have. Memory and time are bounded by the size of the file, whatever its header says. The
// locale plays no part.
//
// Coordinates are the doubles nearest to the decimals in the file, bit for bit; those of binary files are taken as
// they are. Polygons are cut into fans around their first corner. Vertices keep their order. Normals, colours,
// textures, points, lines and curves are ignored. Refused, as they would add to the surface: free-form surfaces and
// other files in OBJ, weights of vertices other than 1, tristrips in PLY.
//
// The readers are the project's own, because those of the libraries at hand do not serve: CGAL's accept damaged files
// (a face "1 2 x" has two corners), allocate what a header claims and name no line; Assimp's round to float.
std::shared_ptr<const Mesh> read_mesh_file(const std::filesystem::path& file);

// Reads each part of the file as a mesh of its own, in the order of their first triangles; the same errors. A mesh is
// named as its part is, or "" if that has no name; names may be equal.
//
// OBJ: "o NAME" begins an object, and "g NAME" a group in it; an object, a group, and a group of an object ("object/
// group") are parts. A line without a name, and each "o", ends the group. Parts that are named alike are one, wherever
// their faces stand: groups may be interleaved. Several names in one line are one name.
// STL: each solid is a part, those named alike too; the second without a name is "solid 2".
// OFF and PLY: one part without a name.
//
// A part without triangles is left out. If only one has any, its mesh is that of read_mesh_file; if several have, each
// mesh has the vertices that its triangles use, in the file's order.
std::vector<NamedMesh> read_mesh_parts(const std::filesystem::path& file);

}  // namespace ecods::scenes
