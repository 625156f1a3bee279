// What engines that report distances say of meshes at known gaps.
#pragma once

#include <span>
#include <vector>

#include "engines/narrow_engine.hpp"
#include "report/table.hpp"
#include "suites/narrow_measure.hpp"

namespace ecods::bench {

// `truth`: of each workload, which queries touch. The name of a workload is its gap in radii. Has no rows where no
// engine reports distances.
Table distance_table(std::span<const scenes::MeshPairs> workloads, std::span<const NarrowTruth> truth,
                     std::span<const NarrowMaker> makers);

}  // namespace ecods::bench
