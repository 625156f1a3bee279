// How deep two parts are in each other: solids with inner points in common.
#pragma once

#include "ecods/intersection.hpp"
#include "ecods/primitives.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

// Whether both are known to be convex, so that their depth is exact.
bool are_convex(const Part& a, const Part& b);

// The depth of convex solids, and quick bounds of that of others. From above: boxes around them are parted along an
// axis. From below: a ball around the middle of the box of common points (`common`), as large as both solids hold it,
// stays met by translations of less than twice its radius; 0 if the middle is not inside both.
Interval depth_of(const Part& a, const Part& b, const Aabb& common, QueryMemory& memory);

// The same with the library's bounds of solids that are not convex, which cost some milliseconds.
Interval narrow_depth_of(const Part& a, const Part& b, QueryMemory& memory);

}  // namespace ecods::clash
