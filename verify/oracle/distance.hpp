// The oracle's distances: what include/ecods/distance.hpp promises, in integers, over all pairs of features of all
// pairs of triangles, and without a tree.
//
// Exact as oracle.hpp promises, in any rounding mode, for all finite doubles; zero-area triangles are the segments and
// points that they span. Posed points are integers in one unit, which a pose of doubles allows. Two triangles share
// a point if two of their features do, or an edge of one passes through the other; otherwise their distance is the
// least one of two vertices, of a vertex and the inside of an edge or a face, or of the insides of two edges that are
// not parallel.
//
// What is left out, and why that is safe: pairs of triangles, and features of a pair, are left out if intervals around
// the same points (interval arithmetic, every operation rounded outwards) prove that others are nearer. Whatever
// intervals do not prove is asked of integers.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "oracle/nearest.hpp"

namespace ecods::oracle {

// A point whose coordinates are exact.
struct ExactPoint {
    std::array<ExactFraction, 3> x;

    Vec3 nearest() const;
};

// As the kinds of include/ecods/distance.hpp, in their order.
enum class Closeness { vertex_vertex, vertex_edge, vertex_face, edge_edge, intersecting };

// A vertex (0), edge (1) or face (2), named by a triangle and its corner; edge i goes from corner i to the next.
struct NamedFeature {
    int dimension = 0;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    friend bool operator==(const NamedFeature&, const NamedFeature&) = default;
};

struct ExactClosest {
    ExactRoot distance;
    Closeness kind = Closeness::intersecting;
    NamedFeature a, b;
    ExactPoint point_a, point_b;
};

// A unit vector along a vector of integers.
struct ExactDirection {
    std::array<mpz_class, 3> v;

    Vec3 nearest() const;
};

// As CloseFeatures and TriangleIntersection of include/ecods/results.hpp.
struct ExactCloseFeatures {
    ExactClosest closest;
    std::optional<ExactDirection> direction;
};
struct ExactIntersection {
    TrianglePair triangles;
    std::vector<ExactPoint> corners;
    std::optional<ExactDirection> normal;
};

struct Soup {
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;
    Pose pose;
};

// Two posed meshes. Refers to the lists of the soups. Cost: a microsecond or two a vertex and about five for a pair of
// triangles that is asked about, three times that where integers decide; of the others the bounds of their boxes are
// compared, for whole blocks first.
class MeshDistances {
  public:
    MeshDistances(const Soup& a, const Soup& b);
    ~MeshDistances();

    ExactRoot distance() const;
    bool within(double d) const;
    ExactClosest closest() const;
    // Every pair within d, which is finite, ascending.
    std::vector<ExactClosest> close_triangles(double d) const;

    // Each feature's name is looked for in the whole mesh.
    std::vector<ExactCloseFeatures> close_features(double d) const;
    std::vector<ExactIntersection> intersections() const;

    // Of one pair of triangles.
    ExactRoot distance(std::uint32_t i, std::uint32_t j) const;
    ExactClosest closest(std::uint32_t i, std::uint32_t j) const;
    // The corners of what they share, ascending by coordinates: a point, the two ends of a segment, a polygon's
    // corners.
    std::vector<ExactPoint> intersection(std::uint32_t i, std::uint32_t j) const;

  private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace ecods::oracle
