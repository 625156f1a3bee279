// Tests the surfaces of two bodies for intersection.
#pragma once

#include "ecods/two_body_test.hpp"

namespace ecods {

// Tests two shapes, which must both be MeshShapes.
class MeshIntersectionTest : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override;
};

}  // namespace ecods
