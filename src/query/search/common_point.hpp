// The test whether two bodies share a point, as a part of another question about them.
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

    // Returns whether two triangles do.
    bool is_in(const TrianglePair& triangles);

    // Counts one more pair of nodes that overlap, and tests the bodies at the last of `overlap_max`. Returns whether
    // they are known to share a point.
    bool is_found_among_overlaps();

  private:
    // A walk that goes deep mostly meets triangles that share a point long before; hundreds of nodes overlap where
    // large bodies nearly touch, too, and there the test would be wasted.
    static constexpr std::uint32_t overlap_max = 1024;

    // Before another query works in the same memory.
    void leave() noexcept;

    const MeshPair& bodies_;
    QueryMemory& memory_;
    bool is_bound_ = false;  // whether the memory's TriangleRelations are bound to the bodies
    std::uint32_t overlap_count_ = 0;
};

}  // namespace ecods
