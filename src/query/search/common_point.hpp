// CommonPoint tests whether two bodies share a point, as a part of another question about them.
#pragma once

#include <cstdint>

#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

class CommonPoint {
  public:
    CommonPoint(const MeshPair& bodies, QueryMemory& memory) : bodies_(bodies), memory_(memory) {}
    ~CommonPoint() { leave(); }
    CommonPoint(const CommonPoint&) = delete;
    CommonPoint& operator=(const CommonPoint&) = delete;

    // True if the two triangles share a point.
    bool is_in(const TrianglePair& triangles);

    // Counts one more pair of nodes that overlap, and tests the bodies when the count reaches `overlap_max`. Returns
    // true if the test finds that they share a point.
    bool is_found_among_overlaps();

  private:
    // A walk through bodies deep in each other mostly meets triangles that share a point long before this. Some hundred
    // pairs of nodes also overlap where large bodies nearly touch; there the test would be wasted.
    static constexpr std::uint32_t overlap_max = 1024;

    // Adds up the counts of the memory's TriangleRelations and unbinds them, before another query works in the memory.
    void leave() noexcept;

    const MeshPair& bodies_;
    QueryMemory& memory_;
    bool is_bound_ = false;  // true if the memory's TriangleRelations are bound to the bodies
    std::uint32_t overlap_count_ = 0;
};

}  // namespace ecods
