#include "exact/measure/distance/fixed_distance.hpp"

#include <array>

#include "exact/measure/round/fixed_length.hpp"
#include "exact/measure/round/fixed_plane.hpp"

namespace ecods::exact {

// Returns the distance of a point from a plane, a line or a point, in the Minkowski difference: there a vertex and a
// face, or two edges, span a plane; a vertex and an edge span a line.
std::optional<double> fixed_distance(const IntegerPair& pair, const FeaturePair& features) noexcept {
    const auto corner = [&](std::size_t side, std::size_t i) -> const IntegerVector& {
        return pair.at[3 * side + (features.corner(side) + i) % 3];
    };
    const auto at = [&](std::size_t a, std::size_t b) { return difference(corner(1, b), corner(0, a)); };
    const bool are_exact = pair.error == 0;
    if (features.kind == FeatureKind::vertex_vertex) return fixed_length(at(0, 0), pair.unit, are_exact);
    const std::size_t other = 1 - features.vertex_side;
    if (features.kind == FeatureKind::vertex_edge) {
        const IntegerVector edge = difference(corner(other, 1), corner(other, 0));
        return fixed_distance_from_line(at(0, 0), edge, pair.unit, are_exact);
    }
    const std::array<IntegerVector, 3> m =
        features.kind == FeatureKind::edge_edge ? std::array<IntegerVector, 3>{at(0, 0), at(1, 0), at(0, 1)}
        : features.vertex_side == 0             ? std::array<IntegerVector, 3>{at(0, 0), at(0, 1), at(0, 2)}
                                                : std::array<IntegerVector, 3>{at(0, 0), at(1, 0), at(2, 0)};
    const FixedPlane plane(m, pair.unit, are_exact);
    return plane.side() ? plane.distance() : std::nullopt;
}

}  // namespace ecods::exact
