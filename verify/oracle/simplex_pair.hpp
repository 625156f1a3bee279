// How two simplices of dimension 0 to 2 meet. Both functions need a FloatEnvironment, and may add exact
// corners to the simplices.
#pragma once

#include "oracle/simplex.hpp"

namespace ecods::oracle {

// Whether they share a point.
bool intersects(Simplex& a, Simplex& b);

// Whether they are not coplanar and some point lies in the relative interior of both. They must share a point.
bool is_crossing(Simplex& a, Simplex& b);

}  // namespace ecods::oracle
