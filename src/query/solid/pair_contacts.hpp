// PairContacts finds how triangles of two posed meshes meet, in the detail that questions about solids need.
#pragma once

#include "ecods/intersection.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_contact.hpp"

namespace ecods {

class PairContacts {
  public:
    // `frame` must be bound to two bodies and outlive this object.
    PairContacts(exact::Frame& frame, StageCounts& counts);

    // Returns the contact of triangle a of the first body with triangle b of the second; b must have an area. It is
    // decided by the cheapest stage that can, as in query/intersection/triangle_relations.cpp.
    exact::TriangleContact contact(const Triangle& a, const Triangle& b);

  private:
    exact::TriangleContact decide(const Triangle& a, const Triangle& b);

    exact::Frame& frame_;
    StageCounts& counts_;
    double bound_;  // error bound of every orient3d of points of both bodies
};

}  // namespace ecods
