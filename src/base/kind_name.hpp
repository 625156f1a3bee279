// Names a kind of shapes, in messages and on streams.
#pragma once

#include <string>

#include "ecods/ids.hpp"

namespace ecods {

std::string name_of(ShapeKind kind);  // "mesh", "rounded", "rounded convex", "half space", "kind 7"

}  // namespace ecods
