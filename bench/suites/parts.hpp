// Parts of suites that have a file of their own.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engines/narrow_engine.hpp"
#include "harness/truths.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

// Narrow: the nanoseconds per triangle that it takes to make meshes ready for queries, for each engine and mesh.
Table build_table(const std::vector<scenes::NamedMesh>& meshes, const std::vector<NarrowMaker>& makers,
                  std::size_t repetition_count);

// Narrow: what engines that report distances say of meshes at known gaps. `truths`: of each workload, which queries
// touch. The name of a workload is its gap in radii. The engines are those of distances that have the name of one of
// `makers`; the table has no rows where there is none.
Table distance_table(std::span<const scenes::MeshPairs> workloads, std::span<const Truths<double>> truths,
                     const std::vector<NarrowMaker>& makers);

// Broad: counts of ECoDS's sweep and prune, which are exact, for dense boxes of growing number.
Table swap_table(std::size_t count_max, std::size_t frame_count);

// Distance: the report's case 2 with a clearance, beside collisions alone. `is_right` becomes false where the two
// worlds differ.
Table clearance_table(const SuiteOptions& options, bool& is_right);

// Convex: a thousand convex solids in a box, frame by frame. Nothing where no engine is wanted; `is_right` becomes
// false where ECoDS is wrong.
std::optional<Table> convex_frames_table(const SuiteOptions& options, bool& is_right);

// Casts: segments against a mesh; casts of two meshes; both in a world, beside questions about two bodies.
SuiteResult run_hits(const SuiteOptions& options);
SuiteResult run_two_body_casts(const SuiteOptions& options);
SuiteResult run_world_casts(const SuiteOptions& options);

}  // namespace ecods::bench
