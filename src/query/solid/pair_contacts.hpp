// Finds how triangles of two posed meshes meet, in the detail that questions about solids need.
#pragma once

#include "ecods/intersection.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_contact.hpp"

namespace ecods {

class PairContacts {
  public:
    // `frame` must be bound to two bodies and outlive this object.
    PairContacts(exact::Frame& frame, StageCounts& counts);

    // The contact of a triangle of the first body with one of the second, found by the cheapest stage that decides it,
    // as in query/intersection/triangle_relations.cpp. The second triangle must have an area.
    exact::TriangleContact contact(const Triangle& a, const Triangle& b);

  private:
    exact::TriangleContact decide(const Triangle& a, const Triangle& b);

    exact::Frame& frame_;
    StageCounts& counts_;
    double bound_;  // bounds the error of every orient3d of points of both bodies
};

}  // namespace ecods
