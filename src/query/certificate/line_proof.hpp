// Proves by a walk of a tree that a segment, or its piece before the first hit, meets no triangle.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

// Proves that the piece from parameter 0 to `end` meets no triangle. This claim must be true. `apart` is half_open if
// triangles may be met at the very end.
void prove_line(const Posed<MeshShape>& body, const Segment& segment, const Parameter& end, ApartBy apart,
                Proof& proof);

}  // namespace ecods
