// Searches for the triangles of a posed mesh that are nearest to a point.
#pragma once

#include <cstdint>
#include <optional>

#include "bvh/walks/walk_point.hpp"
#include "query/distance/distance_search.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

// An OnlyFeature is the only feature of a body that contains a closest point: a face, an open edge or a vertex. It is
// named by the least triangle among those found.
struct OnlyFeature {
    Feature feature;
    // If the feature is a face, `side` is the sign of n . (point - corner), where n is the normal (q - p) x (r - p) of
    // the posed corners p, q and r.
    int side = 0;
};

// PointSearch finds the triangles of a body that are nearest to a point. The point counts as the first body of a pair:
// the mesh of point_shape(), translated. So all results equal those of DistanceSearch. A walk of one tree, and doubles,
// leave few triangles; if floats cannot distinguish nodes, DistanceSearch is used instead.
class PointSearch {
  public:
    // Prepares the search of the body's triangles. `body` and `memory` must outlive the search.
    PointSearch(const Posed<MeshShape>& body, QueryMemory& memory);
    PointSearch(const PointSearch&) = delete;
    PointSearch& operator=(const PointSearch&) = delete;

    // Finds the triangles that may be nearest to the point, which must be finite. The next functions return results for
    // this point; they may be called in any order.
    void find(const Vec3& point);

    // Returns the least distance, rounded once; 0 exactly if the point is on the surface.
    double distance();
    // Returns what closest() returns for the point and the body; point_a need not be set.
    ClosestPoints closest();
    // Returns the feature that certainly contains the only closest point; nullopt if doubles do not prove that there is
    // one, or if the point is on the surface.
    std::optional<OnlyFeature> only() const;

  private:
    struct Memory final : QueryMemoryPart {
        TriangleDistances pair;
        DistanceSieve sieve;
        PointWalk walk;
    };

    Posed<MeshShape> point() const { return {point_shape(), at_}; }
    void take(const NearTriangle& near);
    double round(const DistanceSieve::Open& open);

    const Posed<MeshShape>& posed_;
    const MeshBody body_;
    QueryMemory& memory_;
    Memory& working_;
    QueryCounts& counts_;
    Pose at_;
    PointAxes axes_;
    std::optional<std::uint32_t> touched_;  // the least triangle that contains the point
};

}  // namespace ecods
