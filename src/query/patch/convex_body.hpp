// ConvexBody is a body of a contact patch: a convex core with a radius around it.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"

namespace ecods::patches {

struct ConvexBody {
    // Takes a ConvexSolid, or a Rounded whose core is a ConvexSolid or a mesh of one triangle; such a mesh becomes a
    // flat ConvexSolid. Throws NotSupported for other shapes, and names the argument: the first (0) or second (1) body.
    ConvexBody(const Posed<Shape>& posed, int argument);

    Posed<ConvexSolid> core;
    double radius = 0;
};

// Returns true if contact_patch() takes the two shapes.
bool have_patch(const Shape& a, const Shape& b) noexcept;

}  // namespace ecods::patches
