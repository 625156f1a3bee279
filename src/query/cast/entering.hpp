// Finds when a translated body first goes into another one: a pair of triangles that goes in properly, or an edge that
// slides into a face of its own plane.
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// SlidingEdges says what a search for the first entry must know of solids. Triangles are those of the two meshes that
// are searched.
class SlidingEdges {
  public:
    virtual ~SlidingEdges() = default;

    // False for a triangle of body `side` that does not belong to its boundary.
    virtual bool counts(std::size_t side, std::uint32_t triangle) const = 0;

    // Edge `corner` of a triangle of body `side` is in the plane of triangle `face` of the other body, and this plane
    // is parallel to the motion. Returns the time from 0 to less than `end`, rounded once, from which on the solid at
    // the edge is inside the other solid at the face; nullopt if it is not.
    virtual std::optional<double> time(std::size_t side, std::uint32_t triangle, std::uint32_t corner,
                                       std::uint32_t face, double end) = 0;
};

struct PairEntry {
    double time;
    TrianglePair triangles;  // of the pairs that enter at a time that rounds to this one, the least
};

// Returns the first time at which a pair of triangles goes in properly, or slides in; nullopt if there is none before
// `end`, in real time. Without `edges` no pair slides in. The motion must be finite, and not zero; `end` from 0 to 1.
std::optional<PairEntry> first_entry(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                     double end, SlidingEdges* edges, QueryMemory& memory);

}  // namespace ecods
