// Tests two meshes for intersection.
#pragma once

#include <vector>

#include "ecods/two_body_test.hpp"

namespace ecods {

// Tests two shapes, which must both be MeshShapes.
class MeshIntersectionTest : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override;
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override;
    std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                     const Ask& ask) const override;
};

}  // namespace ecods
