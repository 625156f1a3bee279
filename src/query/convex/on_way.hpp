// are_on_way() decides whether two features, one of each hull, have a pair of points that differ by a known vector.
#pragma once

#include <cstddef>

#include "exact/measure/round/scaled_vector.hpp"
#include "query/convex/closest_hulls.hpp"

namespace ecods::convex {

// Returns true if the interiors of two features, of which none is a face, have exactly one pair of points, of the first
// and of the second hull, that differs by `way`, in units of fixed points, which must be exact. Both features must be
// in one plane after the first is moved by `way`, and the plane must not be parallel to coordinate axis `axis`. Exact.
bool are_on_way(PosedHulls& hulls, const HullFeaturePair& parts, const exact::IntegerVector& way, std::size_t axis);

}  // namespace ecods::convex
