// The oracle: the answers of the contract, by CGAL's exact number types.
//
// It exists to judge the library, so it shares no code with it; of the library it reads plain data types only (Mesh,
// Pose, Aabb, TrianglePair, Relation). A body is the set of the real points R v + t. Here these points are evaluated in
// exact numbers, and CGAL's predicates and intersections are applied to them; intervals decide first where they can.
//
// Promised of every function:
// - Exact for all finite doubles, subnormals and 1e308 included; no tolerance. Sharing one point counts.
// - Complete: no pair of triangles is skipped but for certified boxes (intervals around the exact points).
// - Zero-area triangles are the segments or points that they span. They never reach CGAL's triangle tests, which
//   are order-dependent on them or throw.
// - The caller's rounding mode and flush-to-zero do not matter, and are left as they were.
// - Poses and meshes must be finite (validate(Pose), Mesh::create); this is not checked.
// - No shared state: calls may run from many threads.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::oracle {

// How two posed triangles meet. Crossing: they are not coplanar, and some point lies in the relative interior of
// both (of a segment, the open segment). Touching: everything else that shares a point.
Relation triangle_triangle(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
                           const std::array<Vec3, 3>& b);

// A mesh at a pose, ready to be asked about. Immutable, cheap to copy. Cost: intervals around the posed vertices,
// about 0.1 us a vertex; exact numbers are made only for triangles that intervals leave open.
class OracleMesh {
  public:
    OracleMesh(std::shared_ptr<const Mesh> mesh, const Pose& pose);

    // A box that contains the exact posed mesh: certified, and tight to some units in the last place.
    const Aabb& outer_box() const noexcept;

    struct Impl;  // of the implementation
    const Impl& impl() const noexcept { return *impl_; }

  private:
    std::shared_ptr<const Impl> impl_;
};

// Whether the two soups of closed triangles share a point.
bool intersects(const OracleMesh& a, const OracleMesh& b);

// The strongest relation of any two of their triangles.
Relation relation(const OracleMesh& a, const OracleMesh& b);

// All pairs of triangles that share a point, ascending.
std::vector<TrianglePair> intersecting_triangles(const OracleMesh& a, const OracleMesh& b);

// Both at once, at the cost of the list.
struct Verdict {
    Relation relation = Relation::apart;
    std::vector<TrianglePair> triangles;
};
Verdict verdict(const OracleMesh& a, const OracleMesh& b);

// Whether every exact point of the posed mesh lies in the closed box. (Vertices that no triangle uses do not count.)
bool box_contains(const Aabb& box, const OracleMesh& mesh);

// Whether the closed boxes share a point.
bool boxes_overlap(const Aabb& a, const Aabb& b) noexcept;

// All pairs of indices i < j whose boxes overlap, ascending. Every box is compared with every other.
std::vector<std::pair<std::size_t, std::size_t>> overlapping_boxes(std::span<const Aabb> boxes);

}  // namespace ecods::oracle
