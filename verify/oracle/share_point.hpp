// Decides by a linear program whether two triangles share a point.
#pragma once

#include <gmpxx.h>

#include <array>

#include "oracle/vector.hpp"

namespace ecods::oracle {

using Corners = std::array<Vector<mpz_class>, 3>;

// True if weights of the corners of one make a point of the other.
bool share_point(const Corners& a, const Corners& b);

}  // namespace ecods::oracle
