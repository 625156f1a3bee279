// Solids without dents: how far two of them are from each other, and on which features. No World is needed.
//
// The features of a convex solid are those of the set, however its faces are cut into triangles and its edges into
// pieces: a face is all of its solid in one plane, named by the least of its triangles, with corner 0; an edge is where
// two faces meet, named by the least side of a triangle that lies on it; vertices are the ends of edges, each named by
// the least triangle and corner. All of them by the indices of the mesh; triangles of zero area name nothing. Under a
// pose whose matrix is regular the image of a convex solid is convex, and the images of its features are its features.
//
// Numbers are as in distance.hpp: those of the real points R v + t, rounded once; equal input gives equal bits.
//
// Method: the search of Gilbert, Johnson and Keerthi (A fast procedure for computing the distance between complex
// objects, 1988) in doubles guesses the closest features. The signs of a few determinants prove the guess, since what
// is closest among its neighbors is closest of a convex set; where they do not, exact steps go on from there.
//
// Thread safety: as in intersection.hpp.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "ecods/closest_points.hpp"
#include "ecods/export.hpp"
#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/posed.hpp"
#include "ecods/solid.hpp"

namespace ecods {

// The convex hull of points: its vertices are those points, in the order given, that are no convex combination of
// others, of equal ones the first; its triangles fan out from the least vertex of each face, turned outwards, ascending
// by their vertices. Exact: no point is outside. Throws InvalidMesh, which names the index of a point that is not
// finite, or if there are too many; NotSolid if all points lie in one plane, or there are none.
// Cost: n log n for most points; n f, of f faces, at worst.
ECODS_API Mesh convex_hull(std::span<const Vec3> points);

// The shape of a mesh that bounds a convex solid. It is a Solid, so every question about solids and meshes takes it.
//
// Cost: that of Solid, and an exact sign for each edge. Memory: that of a Solid, about 200 bytes a vertex of the set,
// and 4 bytes a vertex of the mesh.
class ECODS_API ConvexSolid final : public Solid {
  public:
    // Throws InvalidArgument; NotSolid, also if no triangle has area.
    explicit ConvexSolid(std::shared_ptr<const Mesh> mesh);
    // Of the hull of points. Throws as convex_hull() does.
    explicit ConvexSolid(std::span<const Vec3> points);
    ~ConvexSolid() override;

  private:
    friend struct ConvexSolidAccess;

    struct ECODS_HIDDEN ConvexParts;
    std::unique_ptr<ConvexParts> convex_parts_;
};

// The distance of the sets, interiors included: 0 exactly when they share a point. Throws SingularPose. The witness is
// for a pair that was asked about before and has moved little; it may come from any question and any bodies.
// Cost: about a microsecond for solids of some dozens of faces, less with a witness; some microseconds for equal poses
// and other ties that no double decides. Beyond a hundred vertices it grows, at worst, like their number's root.
ECODS_API double solid_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);
ECODS_API double solid_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory,
                                PairWitness& witness);

// The closest points of the sets, and the features that hold them; nothing where the sets share a point (depth.hpp says
// how deep). Where several pairs of features have exactly that distance, the first is given, in the order that
// ClosestPoints names. Exchanging the bodies exchanges a and b, unless several tie. Throws SingularPose.
ECODS_API std::optional<ClosestPoints> solid_closest(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                     QueryMemory& memory);
ECODS_API std::optional<ClosestPoints> solid_closest(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                     QueryMemory& memory, PairWitness& witness);

}  // namespace ecods
