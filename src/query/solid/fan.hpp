// The half-planes of triangles around the line of a segment, in the order of their angles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/point/frame.hpp"

namespace ecods {

// Exact signs of single points of a frame's bodies, for questions that are asked seldom.
class PointSigns {
  public:
    using Point = exact::VertexRef;

    explicit PointSigns(exact::Frame& frame) : frame_(frame) {}

    int orient3d(Point a, Point b, Point c, Point d);
    int orient2d(Point a, Point b, Point c, int axis);
    int compare(Point a, Point b, int axis);
    int normal_axis(Point a, Point b, Point c);

    // Whether b is after a along the direction from p to q, for points of one line, p and q different.
    bool are_in_order(Point p, Point q, Point a, Point b);

  private:
    exact::Frame& frame_;
};

// The half-plane that begins at the line and has the apex in it, which is of the triangle's body.
struct Wing {
    PointSigns::Point apex;
    std::uint32_t triangle;
    bool inside_after;  // whether the sector just after it, turning from p to q as a right-handed screw, is inside
    std::uint32_t group = 0;  // wings of one direction have one number
};

// Sorts wings around the line from p to q, beginning with the direction of the first one, and sets their groups. The
// angle to the first apex w0 is in a half by the sign of orient3d(p, q, w0, w); in the plane of w0, apexes on the same
// side of the line have one sign of orient2d(p, q, w); within a half orient3d(p, q, w, w') orders.
void sort_fan(PointSigns& signs, PointSigns::Point p, PointSigns::Point q, std::vector<Wing>& wings);

}  // namespace ecods
