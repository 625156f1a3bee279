// A convex body of a patch: a convex core, and a radius.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"

namespace ecods::patches {

struct ConvexBody {
    // Throws NotSupported, with the number of the argument, unless the shape is a ConvexSolid, or Rounded with such a
    // core or one triangle; this is then made a flat ConvexSolid.
    ConvexBody(const Posed<Shape>& posed, int argument);

    Posed<ConvexSolid> core;
    double radius = 0;
};

// True if contact_patch() takes the two shapes.
bool have_patch(const Shape& a, const Shape& b) noexcept;

}  // namespace ecods::patches
