// CommonPoint tests whether two bodies share a point, while another search for the same two bodies is running.
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

    // Returns true if the two triangles share a point.
    bool is_in(const TrianglePair& triangles);

    // Counts one more pair of nodes that overlap. When the count reaches `overlap_max`, tests the bodies, and returns
    // true if the bodies share a point. Returns false otherwise.
    bool is_found_among_overlaps();

  private:
    // overlap_max is the number of overlapping pairs of nodes after which the bodies are tested. Large bodies that
    // nearly touch have some hundred overlapping pairs, and the test would be wasted; if bodies overlap deeply, a walk
    // usually finds two triangles that share a point long before overlap_max pairs.
    static constexpr std::uint32_t overlap_max = 1024;

    // Stops using the TriangleRelations in the memory, and adds their counts to those of the memory, so that another
    // query can bind them.
    void leave() noexcept;

    const MeshPair& bodies_;
    QueryMemory& memory_;
    bool is_bound_ = false;  // true if the memory's TriangleRelations are bound to the bodies
    std::uint32_t overlap_count_ = 0;
};

}  // namespace ecods
