// Meshes from files: OBJ, OFF, PLY (text and binary), STL (text and binary).
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "scenes/io/read_error.hpp"
#include "scenes/polygon/polygon_counts.hpp"
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
// they are. Vertices keep their order. Text may begin with the byte order mark of UTF-8.
//
// A polygon of more than three corners is cut into triangles that cover it once, wherever it begins: the fan around its
// first corner if that does, as for each convex one without three corners on one line, and ears otherwise. Dents, holes
// that are joined to the outline by edges there and back, repeated corners and spikes are understood; no corner is
// lost. Corners that are in no plane are cut as they are seen along the axis along which the polygon is largest. If the
// outline crosses itself, nothing covers it: it is cut into the fan, which may be anything. `polygons` counts each
// kind; see polygon/cut_polygon.hpp.
//
// OBJ: "v x y z", perhaps with a weight, which must be 1, or with the three numbers of a colour, finite or not; "f"
// with corners i, i/t, i//n or i/t/n. Normals, texture, smoothing, materials, points, lines and curves are ignored.
// Free-form surfaces and lines that read other files or run commands are errors. OFF: a vertex has what the header says
// (COFF: a colour of three or four numbers, NOFF: a normal, STOFF: texture coordinates); behind the corners of a face,
// a colour may have one, three or four numbers. Each vertex and each face begins a line, but vertices of nothing but
// coordinates may share one. Coordinates and corners may go over several lines; what else belongs to them ends the line
// of the last. PLY: version 1.0; in text, each item has a line of its own, and values are of their declared types.
// Other elements and properties are ignored, but tristrips are an error. A line "Created by ..." in the header is a
// comment: Blender 2.4 forgot to say so. STL: in text, words are parted by blanks and ends of lines alike, and stand
// where the format has them; a name ends with its line or before "facet normal". Binary if the size is that of a binary
// file. Normals and attributes are not looked at.
//
// The readers are the project's own, because those of the libraries at hand do not serve: CGAL's accept damaged files
// (a face "1 2 x" has two corners), allocate what a header claims and name no line; Assimp's round to float.
std::shared_ptr<const Mesh> read_mesh_file(const std::filesystem::path& file, PolygonCounts* polygons = nullptr);

// Reads each part of the file as a mesh of its own, in the order of their first triangles; the same errors. A mesh is
// named as its part is, or "" if that has no name; names may be equal.
//
// OBJ: "o NAME" begins an object and "g NAME" a group in it. A part is an object, a group, or a group of an object,
// named "object/group" unless both have one name. The faces of one object and group are one part wherever they stand:
// groups may be interleaved. A new object begins without a group; "o" or "g" without a name ends the object or the
// group. Several names behind one "g" are one name. A "#" begins a comment where a blank follows: "part #3" is a name.
// STL: each solid is a part, those named alike too; the second without a name is "solid 2".
// OFF and PLY: one part without a name.
//
// A part without triangles is left out. If only one has any, its mesh is that of read_mesh_file; if several have, each
// mesh has the vertices that its triangles use, in the file's order.
std::vector<NamedMesh> read_mesh_parts(const std::filesystem::path& file, PolygonCounts* polygons = nullptr);

}  // namespace ecods::scenes
