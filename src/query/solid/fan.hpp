// Sorts the half-planes of triangles around the line of a segment by angle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/point/frame.hpp"

namespace ecods {

// Gives exact signs of points of a frame's bodies. Each call converts its points, so it is for rare use.
class PointSigns {
  public:
    using Point = exact::VertexRef;

    explicit PointSigns(exact::Frame& frame) : frame_(frame) {}

    int orient3d(Point a, Point b, Point c, Point d);
    int orient2d(Point a, Point b, Point c, int axis);
    int compare(Point a, Point b, int axis);
    int normal_axis(Point a, Point b, Point c);

    // True if b comes after a in the direction from p to q. All four points are on one line, and p differs from q.
    bool are_in_order(Point p, Point q, Point a, Point b);

  private:
    exact::Frame& frame_;
};

// A half-plane bounded by the line: the one that contains `apex`, a vertex of the triangle's body.
struct Wing {
    PointSigns::Point apex;
    std::uint32_t triangle;
    bool inside_after;        // true if the next sector, turning from p to q as a right-handed screw, is inside
    std::uint32_t group = 0;  // equal for wings of one direction
};

// Sorts wings by angle around the line from p to q, from the direction of the first wing on, and sets their groups. Let
// w0 be the first wing's apex. The sign of orient3d(p, q, w0, w) shows which half-turn apex w is in; if it is 0, w is
// in the plane of w0, on the same side of the line if orient2d(p, q, w) has the sign of orient2d(p, q, w0). Within a
// half-turn the sign of orient3d(p, q, w, w') orders w and w'.
void sort_fan(PointSigns& signs, PointSigns::Point p, PointSigns::Point q, std::vector<Wing>& wings);

}  // namespace ecods
