// Ways to decide whether two single triangles, each under its pose, share a point.
#pragma once

#include <span>

#include "scenes/hard_pairs.hpp"
#include "suites/predicate_engines.hpp"

namespace ecods::bench {

// In Answers: the engine refused. It counts as a wrong answer.
inline constexpr std::uint8_t no_answer = 2;

// All begin with poses and vertices as modelled, so that transforms are included in their times.

// The library's public predicate.
Answers answer_by_ecods(std::span<const scenes::PosedPair> pairs);

// The library's decision taken at face value from world vertices rounded to double; and the same with poses, vertices
// and arithmetic in float.
Answers answer_in_double(std::span<const scenes::PosedPair> pairs);
Answers answer_in_float(std::span<const scenes::PosedPair> pairs);

// FCL's triangle test, and CGAL's with the kernel Epick, on world vertices rounded to double.
Answers answer_by_fcl(std::span<const scenes::PosedPair> pairs);
Answers answer_by_epick(std::span<const scenes::PosedPair> pairs);

}  // namespace ecods::bench
