// The oracle's convex solids: what include/ecods/solid.hpp promises of them, in integers, over all pairs of features.
//
// The set of differences { p - q } of two convex polytopes is one, too, and each of its faces belongs to a face of the
// first, a face of the second, or an edge of each: so all normals of faces and all products of edges are tried, and of
// each product it is asked of all vertices whether it is a normal. Of these planes the origin's distances follow. The
// distance of two solids that share no point is the least of two vertices, of a vertex and the inside of an edge or a
// face, or of the insides of two edges that are not parallel. Intervals only prove that some need not be looked at.
//
// Exact as oracle.hpp promises. Cost: some milliseconds for solids of 50 faces.
#pragma once

#include <gmpxx.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracle/convex_features.hpp"
#include "oracle/distance.hpp"

namespace ecods::oracle {

struct ExactDepth {
    ExactRoot depth;
    NamedFeature a, b;
    ExactDirection normal;
};

// Two posed meshes that bound convex solids or cover flat convex sets, under regular poses. Flat sets whose differences
// are in no plane are as solids are; of others, the depth is 0 along that plane's normal.
class ConvexPair {
  public:
    ConvexPair(const Mesh& mesh_a, const Pose& pose_a, const Mesh& mesh_b, const Pose& pose_b);
    ~ConvexPair();

    bool share_a_point() const;
    ExactRoot distance() const;
    std::optional<ExactClosest> closest() const;  // nothing where they share a point
    std::optional<ExactDepth> depth() const;      // nothing where they share none
    // The points that the translation by depth() brings together; nothing where they share none.
    std::optional<ExactClosest> deepest() const;
    // The unit vector from the first to the second; nothing where they share a point.
    std::optional<ExactDirection> direction() const;

    // How many normals have that depth.
    std::size_t depth_tie_count() const;

    // Whether the interiors share no point once b is moved by s.
    bool are_parted_by(const Vec3& s) const;

    // Whether the product of s with the normal of depth() is at least the depth times the normal's length.
    bool is_beyond_depth(const Vec3& s) const;

    // The sign of the length of s less the depth.
    int compare_to_depth(const Vec3& s) const;

  private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

// The sign of the distance of two points less d >= 0, which is finite.
int compare_distance(const Vec3& p, const Vec3& q, double d);

// The hull as include/ecods/shape.hpp has it: its vertices as indices of the points, and its triangles; nothing if
// there are no points. Every plane through three points is tried.
struct HullOfPoints {
    std::vector<std::uint32_t> points;
    std::vector<Triangle> triangles;
};
std::optional<HullOfPoints> hull_of(std::span<const Vec3> points);

}  // namespace ecods::oracle
