// Ways to decide whether two posed triangles meet, on the scenes of predicate_scenes.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "query/intersection/triangle_relations.hpp"
#include "suites/predicate_scenes.hpp"

namespace ecods::bench {

// The answers of all tasks' pairs in order, 1 for a shared point. Each poses for itself what it needs: transforms are
// included.
using Answers = std::vector<std::uint8_t>;

// The library's exact layer; `counts` says which stage decided.
Answers decide_exactly(const PredicateScene& scene, StageCounts* counts = nullptr);

// The same code without filter and exact stage: plain double, taken at face value.
Answers decide_plainly(const PredicateScene& scene);

// CGAL's kernel with exact constructions on exactly transformed points; Epick, on rounded ones.
Answers decide_by_epeck(const PredicateScene& scene);
Answers decide_by_epick(const PredicateScene& scene);

}  // namespace ecods::bench
