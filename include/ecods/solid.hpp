// What is inside what: closed meshes as solids. No World is needed.
//
// A mesh bounds a solid if its triangles of positive area (zero-area ones bound nothing and are left out)
//
//   - are closed: on every line, all but finitely many points lie on an even number of their edges. So a long edge may
//     face two halves, and an edge may be one of four triangles; and
//   - are free of self-intersection: no two of them share a segment or more, except along a side of both. Contacts at
//     isolated points (a vertex on a face, an edge across an edge) are harmless.
//
// Both are decided exactly for the mesh's own coordinates, corners at equal coordinates being one vertex (-0 is 0).
// The solid is the closure of the points of which a ray crosses the surface an odd number of times: how triangles are
// oriented does not matter, and cavities and several shells are allowed. A posed solid is the image of that set, R v +
// t. If R is singular, the image is flat and has no interior. A mesh of zero-area triangles alone bounds the empty set.
//
// A body stays its surface, all triangles of its mesh, in intersects, distance, hits, collisions and everything else
// that other headers say, whether or not its shape is a solid. Interiors count in this header's questions, and nothing
// of zero area that sticks out of a solid does: such a body may intersect another from which its solid is apart.
//
// Answers are exact for the real points and depend on the bits of meshes and poses alone. Poses must be finite; a query
// does not check it. Thread safety: as in intersection.hpp. For coordinates so far apart in scale that
// their integers need thousands of bits, a query uses up to 256 KiB of stack.
//
// Method: signs of determinants of input points alone. Where two triangles that are not coplanar share a segment, the
// half-planes of both solids around its line, sorted, say which regions exist there; a shell without such a segment
// lies on one side of the other solid, which one ray decides, from a point that is moved symbolically. That this is all
// that can happen is proved in src/query/solid/README.md.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <vector>

#include "ecods/closest_points.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Throws unless the mesh bounds a solid: NotSolid, which names an edge that is open, or two triangles that intersect,
// if it is closed. Of several defects the first is named: of edges by triangle and corner, of pairs of triangles the
// least. Cost: about that of the mesh's tree, which it makes, and that of sorting vertices and edges; of a surface that
// is seen as a whole from the middle of its corners, as that of nearly every convex body is, no tree is made.
ECODS_API void check_solid(const Mesh& mesh);

// Every pair of triangles, the lesser index first, that share a segment or more which is not a side of both: those
// that cross, that have a side in the other's face, that overlap in one plane, folded over a common edge or one on the
// other. Ascending. The mesh need not be closed. Zero-area triangles are left out.
ECODS_API std::vector<TrianglePair> self_intersections(const Mesh& mesh);

// The shape of a mesh that bounds a solid. It is a MeshShape, so a World takes it for a body, and every question about
// two meshes takes it.
//
// Cost: that of check_solid at once; what solid_relation needs beside it, some passes over the triangles, when that is
// asked first. Memory: that of a MeshShape, and about 30 bytes a triangle. If corners are not named by one index each,
// or triangles have zero area, or a vertex lies inside an edge, there is a second mesh inside which is without these.
class ECODS_API Solid : public MeshShape {
  public:
    // Throws InvalidArgument or NotSolid.
    explicit Solid(std::shared_ptr<const Mesh> mesh);
    ~Solid() override;

  private:
    friend struct SolidAccess;

    struct ECODS_HIDDEN Parts;
    std::unique_ptr<Parts> solid_parts_;
};

enum class Side : std::uint8_t { outside, on, inside };

// Where a point is with respect to a solid.
struct Location {
    Side side = Side::outside;

    // What the point is on, if it is on the surface: the vertex, the open edge or the open face that holds it, of
    // several the one of lowest dimension and then of the least triangle and corner. Its indices are those of the mesh.
    Feature feature = {};

    friend bool operator==(const Location&, const Location&) = default;
};

// Under a singular pose, outside or on. Throws InvalidArgument unless the point is finite. Cost: one walk of the tree,
// along a ray.
ECODS_API Location locate(const Vec3& point, const Posed<Solid>& solid, QueryMemory& memory);

// How two solids are to each other.
enum class SolidRelation : std::uint8_t {
    apart,        // no point in common
    touching,     // points in common, but no inner points of both
    overlapping,  // inner points of both in common, and neither contains the other
    inside,       // the first is a subset of the second, and not equal to it
    contains,     // the second is a subset of the first, and not equal to it
    equal,        // the same set, whatever the triangles
};

// Subsets may touch the boundary from inside. A solid at a singular pose is apart from others or touches them, which
// it does inside another solid, too. The empty solid is apart from everything. Exchanging a and b exchanges inside and
// contains.
//
// Cost: of solids whose surfaces are apart, that of intersects() and one ray for each shell, of surfaces that meet,
// about that of intersecting_triangles(); a proper crossing ends it.
ECODS_API SolidRelation solid_relation(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory);

// How a surface is to a solid. All triangles of the surface count, zero-area ones as the segments or points that they
// span.
enum class SurfaceRelation : std::uint8_t {
    apart,          // no point in common
    touching,       // points in common, but none of them inside the solid
    inside,         // a subset of the solid, with points inside it
    partly_inside,  // points inside the solid, and points outside
};

// At a singular pose a solid has no inside. Cost: that of intersecting_triangles(), a ray where a triangle leaves the
// solid's surface along an edge, and one for each connected part that does not meet it, which a pass over the triangles
// finds. Points on both sides, once seen, end it.
ECODS_API SurfaceRelation surface_relation(const Posed<MeshShape>& surface, const Posed<Solid>& solid,
                                           QueryMemory& memory);

// "outside", "on", "inside", and so on.
ECODS_API std::ostream& operator<<(std::ostream& out, Side side);
ECODS_API std::ostream& operator<<(std::ostream& out, SolidRelation relation);
ECODS_API std::ostream& operator<<(std::ostream& out, SurfaceRelation relation);

}  // namespace ecods
