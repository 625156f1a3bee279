// How deep are solids in each other? No World is needed.
//
// The depth of two sets that share a point is the length of the shortest translation of one of them after which their
// interiors share none: 0 where they only touch. Of convex solids a and b it is the distance of the origin from the
// boundary of { p - q : p in a, q in b }, so the translation is at right angles to a face of that set: to a face of a,
// a face of b, or to an edge of each. Numbers are as in distance.hpp: of the real points R v + t, rounded once.
//
// Of general solids no exact depth is promised, but proven bounds: depth_bounds().
//
// Method: a polytope inside the set of differences grows toward the faces that are nearest to the origin (van den
// Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001), in doubles; exact signs prove
// that these faces are faces of the set, and that no other is nearer.
//
// Thread safety: as in intersection.hpp.
#pragma once

#include <optional>

#include "ecods/closest_points.hpp"
#include "ecods/convex_solid.hpp"
#include "ecods/export.hpp"
#include "ecods/intersection.hpp"
#include "ecods/posed.hpp"
#include "ecods/solid.hpp"

namespace ecods {

// The shortest translation of b that parts two convex solids.
//
// Its direction is that of an exact normal, which `a` and `b` name: `a` is what of the first solid is furthest along
// it, `b` what of the second is furthest against it, vertices, edges or faces as convex_solid.hpp names them. If `a` is
// a face, the normal is its outer one; otherwise, if `b` is a face, its inner one; otherwise both are edges that are
// not parallel, and it is their product, turned so that it goes out of the first solid. Any vector s of which the
// product with the normal n is at least depth |n|, for the real depth, parts the interiors.
//
// Where several normals give exactly that depth, the first is given: faces of the first solid by their names, then
// faces of the second, then pairs of edges by the name of the first's and then of the second's.
struct Depth {
    double depth = 0;  // rounded once; 0 exactly when the solids touch
    Feature a, b;
    Vec3 direction = Vec3::Zero();  // the unit vector along the normal, each coordinate rounded once; b moves along it

    friend bool operator==(const Depth&, const Depth&) = default;
};

// Returns nothing if the solids share no point (solid_distance() asks for how far). Throws SingularPose. The witness is
// for a pair that was asked about before and has moved little; it may come from any question and any bodies. Cost: some
// microseconds for solids of some dozens of faces; some dozens of microseconds for ten thousand vertices.
ECODS_API std::optional<Depth> depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);
ECODS_API std::optional<Depth> depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory,
                                     PairWitness& witness);

// Proven bounds of the depth of two solids, convex or not: of the length of the shortest translation of one of them
// after which their interiors share no point.
//
// From above: with its pose's translation replaced by `parted`, b shares no inner point with a, as solid_relation()
// says, and `upper` is the length of parted - b.pose.t, rounded up. From below: a ball in each solid, so that shorter
// translations leave their interiors meeting; of convex solids, depth() rounded down. 0 and 0 where the solids touch.
// Both bounds hold; how narrow they are is not promised, and they may differ between versions. Along a direction that
// is tried, `upper` is the length of the way out to some 2^-46 of it, and to 2^-48 of the smaller solid's size, however
// large the other one is. `parted` is made of doubles: where the spacing of these at the pose's translation is more
// than the depth, so is `upper`, and it is infinite where none parts the solids.
struct DepthBounds {
    double lower = 0;
    double upper = 0;
    Vec3 parted = Vec3::Zero();
};

// Returns nothing if the solids share no point. Throws SingularPose. Cost: some dozens of solid_relation(), of casts
// and of distances; of convex solids that of depth() and one or two of solid_relation().
ECODS_API std::optional<DepthBounds> depth_bounds(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory);

}  // namespace ecods
