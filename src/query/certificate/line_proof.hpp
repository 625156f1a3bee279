// The walk of a tree that proves that a segment, or its piece before the first hit, meets none of its triangles.
#pragma once

#include "ecods/posed.hpp"
#include "ecods/segment.hpp"
#include "ecods/shape.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

// The piece goes from parameter 0 to `end`. `apart` is half_open where triangles may be met at the very end. The claim
// must be true.
void prove_line(const Posed<MeshShape>& body, const Segment& segment, const Parameter& end, ApartBy apart,
                Proof& proof);

}  // namespace ecods
