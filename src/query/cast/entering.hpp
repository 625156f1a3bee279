// first_entry() finds the first time at which a translated body goes into another one: a pair of triangles goes in
// properly, or an edge slides into a face in the edge's own plane.
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// SlidingEdges decides for first_entry() how edges of solids slide into faces. Triangles are named by their indices in
// the two meshes that are searched.
class SlidingEdges {
  public:
    virtual ~SlidingEdges() = default;

    // Returns true if the triangle of body `side` belongs to the boundary of that body.
    virtual bool counts(std::size_t side, std::uint32_t triangle) const = 0;

    // Returns the time in [0, end), rounded once, from which on the solid at an edge is inside the other solid at a
    // face; nullopt if there is no such time. Edge `corner` of a triangle of body `side` must be in the plane of
    // triangle `face` of the other body, and this plane must be parallel to the motion.
    virtual std::optional<double> time(std::size_t side, std::uint32_t triangle, std::uint32_t corner,
                                       std::uint32_t face, double end) = 0;
};

struct PairEntry {
    double time;
    TrianglePair triangles;  // the least of all pairs whose time of entry rounds to `time`
};

// Returns the first time at which a pair of triangles goes in properly, or slides in; nullopt if there is none before
// `end`, in real time. If `edges` is null, no pair slides in. The motion must be finite and not zero, and `end` must be
// from 0 to 1.
std::optional<PairEntry> first_entry(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                     double end, SlidingEdges* edges, QueryMemory& memory);

}  // namespace ecods
