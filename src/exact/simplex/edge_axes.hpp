// edges_separate tests if two triangles, which may have no area, are separated by the cross product of one edge of
// each.
//
// The plane of a triangle that is a segment is not known from rounded points, because all its determinants are about
// zero. Without this test, a pair with such a triangle would need integers whenever its boxes meet, and real meshes
// have such triangles. Disjoint convex polygons that neither polygon's plane separates are separated by the cross
// product of an edge of each (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996, section 5). This product is
// certainly not zero for most pairs.
#pragma once

#include <algorithm>

#include "exact/point/point.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Returns true if the cross product of an edge of each triangle certainly separates them. Points 0 to 2 are the corners
// of the first triangle, 3 to 5 the corners of the second. `bound` must be an error bound of every orient3d of these
// points.
//
// Points are projected on n = u x e for an edge u of the first and e of the second triangle, relative to the beginning
// p of u. Both ends of u are at 0, exactly, and both ends of e have the same projection, exactly. The projection of any
// other point x is det(u, e, x - p), a determinant of three differences of the six points, so its error is at most the
// bound. So the two intervals are disjoint if, as computed, one begins more than twice the bound beyond the end of the
// other. Four times the bound also covers the rounding of that difference. An infinite bound proves nothing.
inline bool edges_separate(const Points<6>& w, double bound) noexcept {
    for (std::size_t i = 0; i < 3; ++i) {
        const Point &p = w[i], &q = w[(i + 1) % 3], &r = w[(i + 2) % 3];
        for (std::size_t j = 0; j < 3; ++j) {
            const Point &a = w[3 + j], &b = w[3 + (j + 1) % 3], &c = w[3 + (j + 2) % 3];
            const PlainNormal n = plain_cross(p, q, a, b);
            const double third = plain_side(n, p, r), edge = plain_side(n, p, a), fourth = plain_side(n, p, c);
            if (std::min(edge, fourth) - std::max(third, 0.0) > 4 * bound) return true;
            if (std::min(third, 0.0) - std::max(edge, fourth) > 4 * bound) return true;
        }
    }
    return false;
}

}  // namespace ecods::exact
