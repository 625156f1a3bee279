// Builders make shapes from a few numbers: boxes, prisms, polytopes around curved bodies, height fields, clouds of
// points.
//
//     world.create_body(box({1, 2, 3}), pose);
//     const Circumscribed can = cylinder(0.5, 2, 32);  // contains the real cylinder; can.deviation says how closely
//
// Axes are as in FCL and Coal: bodies are centered at the origin, and prisms, cylinders and cones go along z. (In
// Bullet and Jolt they go along y: there, pose them with a quarter turn.) Sizes are whole lengths and radii, not
// halves, in the caller's unit; they must be finite and positive. The same numbers give the same bits on every machine,
// in any rounding mode.
//
// Errors: InvalidArgument, which names the number ("radius", "sizes(2)", "sides") and, for an entry of a list, its
// index. A size is also refused if half of it is needed and is no double (an odd multiple of 2^-1074), or if a vertex
// would be infinite. Cost: that of ConvexSolid for the same number of vertices, up to five times as much for curved
// bodies.
//
// Example: verify/examples/how_do_i, build_a_body().
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the box of these side lengths. It is exact: no coordinate is rounded. (Bullet's and Jolt's boxes take
// halves.)
[[nodiscard]] ECODS_API std::shared_ptr<const ConvexSolid> box(const Vec3& sizes);

// Returns the prism over a convex polygon, from z = -height / 2 to z = height / 2. It is exact. The polygon may go
// around in either sense; points of it may lie inside its sides, or repeat the point before. Throws InvalidArgument
// also for a polygon that is not convex, with the index of the first point at which it turns the other way than before,
// or begins to go around again; NotSolid if all points are on one line.
[[nodiscard]] ECODS_API std::shared_ptr<const ConvexSolid> prism(std::span<const Vec2> polygon, double height);

// ---- polytopes around curved bodies

// A Circumscribed holds a convex polytope that contains a curved body. The polytope contains the body exactly: the
// plane of each face has the real body, of the sizes as given, on its inner side. So whatever is apart from the
// polytope is apart from the curved body.
struct Circumscribed {
    std::shared_ptr<const ConvexSolid> solid;
    // `deviation` is an upper bound of the distance of the polytope's points from the curved body. For cylinders, cones
    // and balls it is the largest distance, rounded up. For other ellipsoids with at least one subdivision, a vertex on
    // the longest axis attains it, up to the rounding of the vertex's coordinates.
    double deviation = 0;
};

inline constexpr std::uint32_t max_sides = 16384;
inline constexpr std::uint32_t max_subdivisions = 6;

// Returns a prism around the cylinder. `sides` is from 3 to max_sides; the first vertex is on the x axis. The deviation
// is about 5 / sides^2 of the radius: 0.5 % for 32 sides.
[[nodiscard]] ECODS_API Circumscribed cylinder(double radius, double height, std::uint32_t sides);

// Returns a pyramid around the cone with its apex at z = height / 2 and its disc at z = -height / 2. `sides` and the
// deviation are as for a cylinder. The apex of the pyramid is the apex of the cone.
[[nodiscard]] ECODS_API Circumscribed cone(double radius, double height, std::uint32_t sides);

// Returns a polytope around the ellipsoid whose half axes are `radii`; equal radii make a ball. (The exact ball is the
// Rounded shape of a point.) It is an icosahedron whose triangles are divided into four, `subdivisions` times, from 0
// to max_subdivisions: it has 12, 42, 162, 642, 2562, 10,242 or 40,962 vertices. The deviation is about 26, 7, 1.8,
// 0.45, 0.11, 0.03 or 0.007 % of the longest radius.
[[nodiscard]] ECODS_API Circumscribed ellipsoid(const Vec3& radii, std::uint32_t subdivisions);

// ---- height fields and clouds

// Returns the surface over a grid of heights (Bullet: btHeightfieldTerrainShape; Jolt: HeightFieldShape). `heights` has
// rows of `columns` heights each; at least two rows and two columns are needed. Height number i of row j is vertex j *
// columns + i of the mesh, at x = i * spacing.x and y = j * spacing.y, each rounded once, and z = height. Each cell is
// cut into two triangles by the diagonal from its first vertex to its last: of cell c, counted by rows, triangle 2 c +
// 1 is the one with the greater y. Triangles face up. Throws InvalidMesh for a height that is not finite, with its
// index, or for too many heights.
[[nodiscard]] ECODS_API std::shared_ptr<const MeshShape> height_field(std::span<const double> heights,
                                                                      std::size_t columns, const Vec2& spacing);

// Returns the solid between the surface and the plane z = base, which must be below all heights (Coal: HeightField;
// MuJoCo: hfield). Its first vertices and triangles are those of the surface.
[[nodiscard]] ECODS_API std::shared_ptr<const Solid> height_field(std::span<const double> heights, std::size_t columns,
                                                                  const Vec2& spacing, double base);

// Returns the points as a body: triangle i is the point {i, i, i}. Throws InvalidMesh if a point is not finite, or if
// there are no points. For points with a radius, round it (rounded.hpp). Cost: about a microsecond a point with its
// tree, and some 100 bytes, of which 66 are the tree's; the distance of a point or a ball from a million points takes
// some tens of microseconds.
[[nodiscard]] ECODS_API std::shared_ptr<const MeshShape> point_cloud(std::span<const Vec3> points);

}  // namespace ecods
