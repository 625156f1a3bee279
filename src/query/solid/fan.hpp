// Sorts half-planes by their angle around the line of a segment.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/point/frame.hpp"

namespace ecods {

// PointSigns computes exact signs of orient2d, orient3d and coordinate comparisons for vertices of a frame's bodies. It
// is slow, because each call converts its points again.
class PointSigns {
  public:
    using Point = exact::VertexRef;

    explicit PointSigns(exact::Frame& frame) : frame_(frame) {}

    int orient3d(Point a, Point b, Point c, Point d);
    int orient2d(Point a, Point b, Point c, int axis);
    int compare(Point a, Point b, int axis);
    int normal_axis(Point a, Point b, Point c);

    // Returns true if b comes after a in the direction from p to q. All four points must be on one line, and p must
    // differ from q.
    bool are_in_order(Point p, Point q, Point a, Point b);

  private:
    exact::Frame& frame_;
};

// A Wing is a half-plane bounded by the line: the one that contains `apex`, a vertex of the triangle's body. The sector
// after a wing is the next one in a right-handed turn around the line from p to q.
struct Wing {
    PointSigns::Point apex;
    std::uint32_t triangle;
    bool inside_after;        // true if the sector after the wing is inside
    std::uint32_t group = 0;  // equal for wings in the same direction
};

// Sorts wings by angle around the line from p to q, beginning in the direction of the first wing, and sets their
// groups. Let w0 be the apex of the first wing. The sign of orient3d(p, q, w0, w) determines the half-turn of an apex
// w. If the sign is 0, w is in the plane of p, q and w0, and on the same side of the line as w0 if orient2d(p, q, w)
// has the sign of orient2d(p, q, w0). Within a half-turn, the sign of orient3d(p, q, w, w') orders w and w'.
void sort_fan(PointSigns& signs, PointSigns::Point p, PointSigns::Point q, std::vector<Wing>& wings);

}  // namespace ecods
