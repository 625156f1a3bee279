// with_signs provides exact signs of determinants of points of a frame's bodies, in the cheapest arithmetic.
#pragma once

#include <array>

#include "exact/point/frame.hpp"
#include "exact/sign/difference_signs.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Returns an error bound of orient3d for all rounded points of a frame. The bound holds until Frame::find_arithmetic()
// is called.
// Claim: verify/proofs/filter_bound.py
inline double orient3d_bound(const Frame& frame) noexcept {
    const Vec3& extent = frame.extent();
    return orient3d_bound(difference_bound({extent[0], extent[1], extent[2]}, frame.delta()));
}

// Returns error bounds of all determinants of a frame's points. `delta` is an upper bound of the error of a coordinate.
inline DeterminantBounds determinant_bounds(const Frame& frame, double delta) noexcept {
    const Vec3& extent = frame.extent();
    return determinant_bounds({extent[0], extent[1], extent[2]}, delta);
}

// Calls ask(signs) and returns the result of ask(); `signs` is a provider of exact signs, for which point i is
// vertices[i]. `ask` must accept every provider of this folder.
//
// Cost: a bound is computed for just these points, and the points are converted to integers even if the integers are
// not needed. If the filter decides most cases, try the determinants in doubles with orient3d_bound(frame) first, as
// query/intersection does.
template <std::size_t N, class Ask>
auto with_signs(Frame& frame, const std::array<VertexRef, N>& vertices, Ask&& ask) {
    frame.find_arithmetic();
    const Points<N> points = frame.rounded(vertices);
    if (frame.arithmetic() == Arithmetic::plain) {
        PlainSigns<N> signs(points);
        return ask(signs);
    }
    if (frame.arithmetic() == Arithmetic::differences) {
        DifferenceSigns<N> signs(points, frame.to_integers());
        return ask(signs);
    }
    const DeterminantBounds bounds = determinant_bounds(points, frame.delta());
    return frame.with_integers(vertices, [&](const auto& integers) {
        FilteredSigns signs(points, bounds, integers);
        return ask(signs);
    });
}

}  // namespace ecods::exact
