// Proves, by a walk of a tree, that a segment, or its piece before the first hit, meets no triangle.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

// Writes to `proof` that the piece of the segment from parameter 0 to `end` meets no triangle. Call this function only
// if the piece meets no triangle. If the last point of the piece may touch triangles, `apart` must be half_open;
// otherwise strictly.
void prove_line(const Posed<MeshShape>& body, const Segment& segment, const Parameter& end, ApartBy apart,
                Proof& proof);

}  // namespace ecods
