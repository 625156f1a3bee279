// What segments really hit.
#pragma once

#include <cstddef>
#include <vector>

#include "ecods/hit.hpp"
#include "scenes/segment_workloads.hpp"

namespace ecods::bench {

// All hits of each segment, of triangles that are numbered through all bodies: those of ECoDS, of which so many lists,
// spread evenly, are judged by the oracle; those count as wrong that differ from its own.
struct HitTruth {
    std::vector<std::vector<Hit>> lists;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;

    std::size_t hit_segment_count() const;
};
HitTruth find_hits(const scenes::SegmentWorkload& workload, std::size_t judged_count);

}  // namespace ecods::bench
