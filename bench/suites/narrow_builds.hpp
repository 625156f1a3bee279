// What it takes to make meshes ready for queries.
#pragma once

#include <span>
#include <vector>

#include "engines/narrow_engine.hpp"
#include "report/table.hpp"

namespace ecods::bench {

// Nanoseconds per triangle for each engine and mesh.
Table build_table(const std::vector<scenes::NamedMesh>& meshes, std::span<const NarrowMaker> makers,
                  std::size_t repetition_count);

}  // namespace ecods::bench
