// Where two parts clash.
#pragma once

#include <cstddef>

#include "ecods/intersection.hpp"
#include "ecods/primitives.hpp"
#include "programs/clash/report.hpp"
#include "programs/clash/verdict.hpp"

namespace ecods::clash {

// The place of a verdict about these parts, without points and lines but those of a clearance. Cost: a pass over the
// vertices.
Place place_of(const Part& a, const Part& b, const Verdict& verdict, QueryMemory& memory);

// The same with the least box, points, and at most so many lines. Cost: some microseconds for each pair of triangles
// that meet.
Place place_with_lines(const Part& a, const Part& b, const Verdict& verdict, std::size_t line_limit,
                       QueryMemory& memory);

// A box that holds the part: of a part that is not moved the least one.
Aabb bounds_of(const Part& part);

}  // namespace ecods::clash
