// PairContacts computes the contacts of triangles of two posed meshes, in the detail that relations of solids need.
#pragma once

#include "ecods/intersection.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_contact.hpp"

namespace ecods {

class PairContacts {
  public:
    // Computes contacts of the two bodies to which `frame` is bound. `frame` must outlive this object.
    PairContacts(exact::Frame& frame, StageCounts& counts);

    // Returns the contact of triangle a of the first body with triangle b of the second; b must have an area. The
    // cheapest stage that decides the contact returns it, as in query/intersection/triangle_relations.cpp.
    exact::TriangleContact contact(const Triangle& a, const Triangle& b);

  private:
    exact::TriangleContact decide(const Triangle& a, const Triangle& b);

    exact::Frame& frame_;
    StageCounts& counts_;
    double bound_;  // error bound of every orient3d of points of both bodies
};

}  // namespace ecods
