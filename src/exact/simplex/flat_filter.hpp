// filter_flat tests in doubles, with one error bound, if two triangles in one plane share a point. The triangles are
// projected along a coordinate axis. Points 0 to 2 are the corners of the first triangle, 3 to 5 the corners of the
// second.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "exact/point/point.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

enum class FlatAnswer : std::uint8_t { disjoint, touching, unknown };

// Returns the filter's FlatAnswer for the two triangles. `bound` must be an error bound of every orient2d of the six
// points along the axis. As in coplanar_pair() (triangle_pair.hpp), the triangles are disjoint if and only if all of
// one is strictly on the outer side of an edge of the other. An edge certainly separates the triangles if all three
// values are beyond the bound. No edge separates them if each edge has a corner of the other triangle certainly on its
// inner side. Both answers need certain turns of the triangles. If the bound is infinite, the result is `unknown`.
inline FlatAnswer filter_flat(const Points<6>& w, int axis, double bound) noexcept {
    bool may_separate = false;
    for (const std::size_t own : {std::size_t{0}, std::size_t{3}}) {
        const std::size_t other = 3 - own;
        const int turn = certain_sign(plain_orient2d(w[own], w[own + 1], w[own + 2], axis), bound);
        if (turn == 0) return FlatAnswer::unknown;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point &from = w[own + i], &to = w[own + (i + 1) % 3];
            double inmost = turn * plain_orient2d(from, to, w[other], axis);
            inmost = std::max(inmost, turn * plain_orient2d(from, to, w[other + 1], axis));
            inmost = std::max(inmost, turn * plain_orient2d(from, to, w[other + 2], axis));
            if (inmost < -bound) return FlatAnswer::disjoint;
            may_separate |= !(inmost > bound);
        }
    }
    return may_separate ? FlatAnswer::unknown : FlatAnswer::touching;
}

}  // namespace ecods::exact
