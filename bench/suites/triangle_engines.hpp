// Ways to decide whether two triangles meet, each under its pose: triangles of bodies, and single ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "query/intersection/triangle_relations.hpp"
#include "scenes/hard_pairs.hpp"
#include "suites/predicate_scenes.hpp"

namespace ecods::bench {

// The answers in order, 1 for a shared point. Each engine begins with poses and vertices as modelled, so that
// transforms are included in its times.
using Answers = std::vector<std::uint8_t>;

// The engine refused. It counts as a wrong answer.
inline constexpr std::uint8_t no_answer = 2;

// The library's exact layer, for the pairs of all tasks; `counts` says which stage decided. And its public predicate.
Answers decide_exactly(const PredicateScene& scene, StageCounts* counts = nullptr);
Answers answer_by_ecods(std::span<const scenes::PosedPair> pairs);

// The same code without filter and exact stage: plain double, taken at face value, of world vertices rounded to double;
// and the same with poses, vertices and arithmetic in float.
Answers decide_plainly(const PredicateScene& scene);
Answers answer_in_double(std::span<const scenes::PosedPair> pairs);
Answers answer_in_float(std::span<const scenes::PosedPair> pairs);

// CGAL's kernel with exact constructions on exactly transformed points; Epick, on rounded ones.
Answers decide_by_epeck(const PredicateScene& scene);
Answers decide_by_epick(const PredicateScene& scene);
Answers answer_by_epick(std::span<const scenes::PosedPair> pairs);

// FCL's triangle test, the one that its meshes are tested with, on world vertices rounded to double.
Answers answer_by_fcl(std::span<const scenes::PosedPair> pairs);

}  // namespace ecods::bench
