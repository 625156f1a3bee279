// exact_parts() finds the parts of a line inside a solid, with the exact parameters where the parts begin.
#pragma once

#include <vector>

#include "ecods/hit.hpp"
#include "ecods/solid.hpp"
#include "query/hit/exact_hits.hpp"

namespace ecods {

struct ExactPart {
    LongFraction from;
    InsidePart part;
};

// Return the parts of the line inside the solid, as inside_parts() does, but with exact parameters. The line must be
// valid.
std::vector<ExactPart> exact_parts(const Segment& segment, const Posed<Solid>& solid, QueryMemory& memory);
std::vector<ExactPart> exact_parts(const Ray& ray, const Posed<Solid>& solid, QueryMemory& memory);

}  // namespace ecods
