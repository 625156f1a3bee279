#include "query/convex/on_way.hpp"

#include "exact/measure/round/fixed_digits.hpp"

namespace ecods::convex {
namespace {

using exact::Int256;
using exact::IntegerVector;

// Returns true if the point at z, relative to the beginning of the edge u, is inside the edge.
bool is_inside(const IntegerVector& z, const IntegerVector& u) noexcept {
    const Int256 along = exact::dot_of(z, u);
    return exact::bit_width(exact::cross(z, u)) == 0 && exact::sign(along) > 0 &&
           exact::sign(exact::square_of(u) - along) > 0;
}

// Returns true if the edges s u and d + r v, 0 < s < 1 and 0 < r < 1, cross in one point. The edges are in one plane.
// With the coordinate `axis` left out, s = (d x v) / (u x v) and r = (d x u) / (u x v).
bool do_cross(const IntegerVector& u, const IntegerVector& v, const IntegerVector& d, std::size_t axis) noexcept {
    const Int256 n = exact::cross(u, v)[axis];
    const int turn = exact::sign(n);
    const auto is_parameter = [&](const Int256& x) { return exact::sign(x) == turn && exact::sign(n - x) == turn; };
    return turn != 0 && is_parameter(exact::cross(d, v)[axis]) && is_parameter(exact::cross(d, u)[axis]);
}

}  // namespace

bool are_on_way(PosedHulls& hulls, const HullFeaturePair& parts, const IntegerVector& way, std::size_t axis) {
    const HullFeatures found = features_of(hulls, parts);
    const auto from = [&](std::size_t side) { return hulls.fixed({side, found.corners[side][0]}); };
    const auto edge = [&](std::size_t side) {
        return exact::difference(hulls.fixed({side, found.corners[side][1]}), from(side));
    };
    const IntegerVector d = exact::difference(exact::difference(from(1), from(0)), way);
    if (found.features.kind == exact::FeatureKind::vertex_vertex) return (d[0] | d[1] | d[2]) == 0;
    if (found.features.kind == exact::FeatureKind::edge_edge) return do_cross(edge(0), edge(1), d, axis);
    const std::size_t side = found.features.vertex_side;
    return is_inside(side == 1 ? d : exact::difference(IntegerVector{}, d), edge(1 - side));
}

}  // namespace ecods::convex
