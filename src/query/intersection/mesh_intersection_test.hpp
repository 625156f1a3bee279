// Tests two meshes for intersection.
#pragma once

#include <vector>

#include "ecods/shape.hpp"

namespace ecods {

// Both shapes must be MeshShapes.
class MeshIntersectionTest : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const override;
    bool intersects_again(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory,
                          PairWitness& witness) const override;
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const override;
    std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                     QueryMemory& memory) const override;
};

}  // namespace ecods
