// How triangles of two posed meshes meet, as much of it as questions about solids need.
#pragma once

#include "ecods/intersection.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_contact.hpp"

namespace ecods {

class PairContacts {
  public:
    // `frame` is bound to two bodies, and outlives the questions.
    PairContacts(exact::Frame& frame, StageCounts& counts);

    // The contact of a triangle of the first body and one of the second; that of the second has an area. By the
    // cheapest stage that decides, as in query/intersection/triangle_relations.cpp.
    exact::TriangleContact contact(const Triangle& a, const Triangle& b);

  private:
    exact::TriangleContact decide(const Triangle& a, const Triangle& b);

    exact::Frame& frame_;
    StageCounts& counts_;
    double bound_;  // for every orient3d of points of the two
};

}  // namespace ecods
