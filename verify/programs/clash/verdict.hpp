// What kind of clash two parts have, exactly.
#pragma once

#include <optional>
#include <string_view>

#include "ecods/intersection.hpp"
#include "ecods/pose.hpp"
#include "ecods/solid.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

struct Verdict {
    Kind kind = Kind::touching;
    std::string_view relation = {};       // as Clash has it
    std::optional<double> distance = {};  // of kind clearance
};

// Solids are judged as solids; a part that is none, as a surface (solid.hpp, intersection.hpp). Solids that are apart
// touch where zero-area triangles of one meet the other's surface. Distances are those of
// the surfaces, zero-area triangles included (distance.hpp). Nothing if the parts have no point in common and, where a
// clearance is given, are at a greater distance; the clearance must be neither negative nor NaN.
//
// `can_be_deep` may be false only if the parts have no inner points in common and no triangles of zero area, for which
// boxes around them may vouch: whether they touch is then asked of their surfaces, which costs less.
std::optional<Verdict> judge_pair(const Part& a, const Part& b, std::optional<double> clearance, QueryMemory& memory,
                                  bool can_be_deep = true);

// The part's shape at its pose: as what it is, as its surface with all triangles, and as the solid that it must be.
Posed<MeshShape> body_of(const Part& part);
Posed<MeshShape> surface_of(const Part& part);
Posed<Solid> solid_of(const Part& part);

}  // namespace ecods::clash
